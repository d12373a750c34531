#include "snug/object/turned_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace snug {
namespace {

constexpr std::size_t kBoxes = BoxGroup::kBoxes;

/// How far a surface reaches in one direction: the most promising boxes first, the others not at all.
class Furthest {
  public:
    Furthest(const SurfaceClusters& surface, Vec3d direction)
        : surface_(surface), direction_(direction), slack_(2e-6f * 3 * surface.largest) {}

    double find() {
        visit(surface_.levels.size() - 1, 0);
        return furthest_;
    }

  private:
    void visit(std::size_t level, std::size_t group) {
        BoxGroup::Lanes ends = ends_of(surface_.levels[level].groups[group]);
        const std::size_t first = group * kBoxes;
        const std::size_t count = std::min(kBoxes, surface_.levels[level].boxes - first);
        for (std::size_t turn = 0; turn < count; ++turn) {
            const auto next = std::max_element(ends.begin(), ends.begin() + static_cast<int>(count));
            if (*next <= furthest_) return;
            *next = -std::numeric_limits<float>::infinity();
            const std::size_t box = first + static_cast<std::size_t>(next - ends.begin());
            if (level > 0)
                visit(level - 1, box);
            else
                look_at(surface_.clusters[box]);
        }
    }

    /// Above the end of everything within each box, whatever the rounding.
    [[nodiscard]] BoxGroup::Lanes ends_of(const BoxGroup& group) const {
        const Vec3f d = vec_cast<float>(direction_);
        const Vec3f size{std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)};
        const auto& [cx, cy, cz] = group.centre;
        const auto& [hx, hy, hz] = group.half;
        BoxGroup::Lanes ends;
        for (std::size_t i = 0; i < kBoxes; ++i)
            ends[i] = (d.x * cx[i] + d.y * cy[i] + d.z * cz[i]) +
                      (size.x * hx[i] + size.y * hy[i] + size.z * hz[i] + slack_);
        return ends;
    }

    void look_at(const SurfaceClusters::Cluster& cluster) {
        const std::size_t count = cluster.padded();
        const float* const x = surface_.coordinates.data() + cluster.first_coordinate;
        for (std::size_t i = 0; i < count; ++i) {
            const Vec3f vertex{x[i], x[count + i], x[2 * count + i]};
            furthest_ = std::max(furthest_, dot(direction_, vec_cast<double>(vertex)));
        }
    }

    const SurfaceClusters& surface_;
    Vec3d direction_;
    float slack_;
    double furthest_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

Box3d turned_bounds(const SurfaceClusters& surface, const Rotation& rotation) {
    if (surface.clusters.empty()) return {};
    const auto reach = [&surface](Vec3d direction) { return Furthest(surface, direction).find(); };
    const auto& [x, y, z] = rotation.row;
    const Vec3d max{reach(x), reach(y), reach(z)};
    const Vec3d min{-reach(-x), -reach(-y), -reach(-z)};
    return {min, max};
}

}  // namespace snug
