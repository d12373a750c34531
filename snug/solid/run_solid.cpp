#include "snug/solid/run_solid.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "snug/base/box.h"

namespace snug {
namespace {

constexpr int kAround = 8;  // blocks around a corner

/// Builds the surface face by face. Vertices are told apart by their corner and by which of the blocks around
/// it they belong to: blocks that hang together by faces around the corner share one.
class Builder {
  public:
    explicit Builder(const Grid<Run>& runs) : runs_(runs) {}

    RunSurface build() {
        for (int j = 0; j < runs_.ny(); ++j)
            for (int k = 0; k < runs_.nz(); ++k)
                for (int i = runs_(j, k).first; i < runs_(j, k).end; ++i) add_block({i, j, k});
        return std::move(surface_);
    }

  private:
    [[nodiscard]] bool filled(Vec3i block) const {
        if (!runs_.contains(block.y, block.z)) return false;
        const Run run = runs_(block.y, block.z);
        return block.x >= run.first && block.x < run.end;
    }

    void add_block(Vec3i block) {
        for (int axis = 0; axis < 3; ++axis) {
            for (int side = 0; side < 2; ++side) {
                Vec3i next = block;
                next[axis] += side == 0 ? -1 : 1;
                if (!filled(next)) add_face(block, axis, side);
            }
        }
    }

    void add_face(Vec3i block, int axis, int side) {
        const int across = (axis + 1) % 3, along = (axis + 2) % 3;
        constexpr std::array<std::array<int, 2>, 4> kRound{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
        std::array<std::uint32_t, 8> outline{};
        std::uint32_t count = 0;
        for (std::size_t step = 0; step < 4; ++step) {
            Vec3i corner = block, next = block;
            corner[axis] += side;
            next[axis] += side;
            corner[across] += kRound[step][0];
            corner[along] += kRound[step][1];
            next[across] += kRound[(step + 1) % 4][0];
            next[along] += kRound[(step + 1) % 4][1];
            outline[count++] = vertex(corner, block);
            if (meets_in_edge_only(block, axis, side, corner, next))
                outline[count++] = middle_vertex(corner, next, block);
        }
        // The outline turns about +axis; on the low side it must turn the other way.
        if (side == 0) std::reverse(outline.begin(), outline.begin() + count);
        add_fan(std::span(outline).first(count));
    }

    /// With points in the middle of its edges a face has a point in its own middle too, so that no triangle
    /// is flat.
    void add_fan(std::span<const std::uint32_t> outline) {
        if (outline.size() == 4) {
            surface_.triangles.push_back({outline[0], outline[1], outline[2]});
            surface_.triangles.push_back({outline[0], outline[2], outline[3]});
            return;
        }
        Box3d bounds;
        for (const std::uint32_t v : outline) bounds.include(surface_.points[v]);
        const auto middle = static_cast<std::uint32_t>(surface_.points.size());
        surface_.points.push_back(bounds.centre());
        for (std::size_t i = 0; i < outline.size(); ++i)
            surface_.triangles.push_back({middle, outline[i], outline[(i + 1) % outline.size()]});
    }

    /// Whether across an edge of the face only the diagonal block is filled.
    [[nodiscard]] bool meets_in_edge_only(Vec3i block, int axis, int side, Vec3i a, Vec3i b) const {
        const int edge_axis = a.x != b.x ? 0 : a.y != b.y ? 1 : 2;
        const int other = 3 - axis - edge_axis;
        Vec3i beside = block;
        beside[other] += a[other] > block[other] ? 1 : -1;
        Vec3i diagonal = beside;
        diagonal[axis] += side == 0 ? -1 : 1;
        return filled(diagonal) && !filled(beside);
    }

    std::uint32_t vertex(Vec3i corner, Vec3i block) {
        const auto bit_of = [&](Vec3i b) {
            return (b.x < corner.x ? 0 : 1) + (b.y < corner.y ? 0 : 2) + (b.z < corner.z ? 0 : 4);
        };
        int around = 0;
        for (int bit = 0; bit < kAround; ++bit)
            if (filled({corner.x - 1 + (bit & 1), corner.y - 1 + (bit >> 1 & 1), corner.z - 1 + (bit >> 2)}))
                around |= 1 << bit;
        int group = 1 << bit_of(block);
        for (int before = 0; before != group;) {
            before = group;
            for (int bit = 0; bit < kAround; ++bit)
                if (group >> bit & 1)
                    for (const int step : {1, 2, 4}) group |= around & (1 << (bit ^ step));
        }
        return numbered({corner.x * 2, corner.y * 2, corner.z * 2, group}, vec_cast<double>(corner));
    }

    std::uint32_t middle_vertex(Vec3i a, Vec3i b, Vec3i block) {
        // Only one of the two blocks at the edge is on this side of it along both axes.
        const Vec3i twice = a + b;
        const int owner = (block.x * 2 + 1 < twice.x ? 0 : 1) + (block.y * 2 + 1 < twice.y ? 0 : 2) +
                          (block.z * 2 + 1 < twice.z ? 0 : 4);
        return numbered({twice.x, twice.y, twice.z, owner}, vec_cast<double>(twice) * 0.5);
    }

    std::uint32_t numbered(std::tuple<int, int, int, int> key, Vec3d at) {
        const auto [place, added] = numbers_.emplace(key, static_cast<std::uint32_t>(surface_.points.size()));
        if (added) surface_.points.push_back(at);
        return place->second;
    }

    const Grid<Run>& runs_;
    RunSurface surface_;
    std::map<std::tuple<int, int, int, int>, std::uint32_t> numbers_;
};

}  // namespace

RunSurface run_surface(const Grid<Run>& runs) {
    return Builder(runs).build();
}

Solid run_solid(const Grid<Run>& runs, const DesignSpace& space) {
    RunSurface surface = run_surface(runs);
    Solid solid{{}, std::move(surface.triangles)};
    solid.vertices.reserve(surface.points.size());
    for (const Vec3d& at : surface.points) {
        Vec3d position;
        for (int axis = 0; axis < 3; ++axis)
            position[axis] = (2.0 * at[axis] - space.blocks[axis]) * 0.5 * space.block_mm[axis];
        solid.vertices.push_back(vec_cast<float>(position));
    }
    return solid;
}

}  // namespace snug
