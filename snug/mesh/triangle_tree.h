#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "snug/base/box.h"
#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/base/vec.h"

namespace snug {

/// The nearest point of a set and how far it lies; `distance` is the limit that was asked for where the set
/// has no point within it, and then `point` says nothing.
struct NearestPoint {
    Vec3d point;
    double distance = 0;
    /// Boxes and members of the set that were looked at to find it; a triangle takes as long as several
    /// boxes.
    std::uint32_t looked_at = 0;
    static constexpr std::uint32_t kLooksOfTriangle = 8;
};

/// The point of triangle abc (which may have no area) that is nearest to p.
[[nodiscard]] Vec3d nearest_on_triangle(Vec3d a, Vec3d b, Vec3d c, Vec3d p);

/// A bounding volume hierarchy: triangles in the order of a Morton curve, four to a leaf, four children to a
/// node. The boxes hold floats, rounded outward; distances are exact but for rounding in double.
/// Keeps a view of the vertices, which must outlive it; their coordinates must be finite.
class TriangleTree {
  public:
    /// Fails only when cancelled.
    [[nodiscard]] static Result<TriangleTree> build(std::span<const Vec3d> vertices,
                                                    std::span<const Triangle> triangles,
                                                    const Progress& progress = {});

    /// The point of the surface nearest to p, not farther than `at_most`. The search ends early once it knows
    /// a point not farther than `enough`, which then need not be the nearest.
    [[nodiscard]] NearestPoint nearest(Vec3d p, double at_most, double enough = 0) const;

    /// Calls visit(triangle) for every triangle whose bounding box meets `box`, bounds included, and possibly
    /// for some near it. The box may be unbounded. Returns how many boxes and triangles it looked at.
    template <class Visit>
    std::uint32_t for_each_near(const Box3d& box, Visit visit) const;

  private:
    static constexpr std::size_t kFanOut = 4;
    static constexpr std::size_t kMostLevels = 17;  ///< 4^17 exceeds the number of triangles

    struct FloatBox {
        Vec3f min;
        Vec3f max;
    };
    struct Node {
        std::uint32_t level;  ///< 0 for leaves
        std::uint32_t index;
    };
    /// A path down the tree keeps at most three siblings a level.
    using Stack = std::array<Node, kMostLevels * kFanOut>;

    TriangleTree() = default;
    void build_leaves();
    void build_level_above();
    [[nodiscard]] const FloatBox& box(Node node) const { return levels_[node.level][node.index]; }
    [[nodiscard]] Node root() const { return {static_cast<std::uint32_t>(levels_.size()) - 1, 0}; }
    /// The children of a node, or the triangles of a leaf.
    struct Range {
        std::size_t first;
        std::size_t end;
    };
    [[nodiscard]] Range below(Node node) const {
        const std::size_t first = node.index * kFanOut;
        const std::size_t size = node.level == 0 ? triangles_.size() : levels_[node.level - 1].size();
        return {first, std::min(first + kFanOut, size)};
    }

    std::span<const Vec3d> vertices_;
    std::vector<Triangle> triangles_;            ///< along the Morton curve
    std::vector<std::vector<FloatBox>> levels_;  ///< leaves first, the root last
};

template <class Visit>
std::uint32_t TriangleTree::for_each_near(const Box3d& query, Visit visit) const {
    if (triangles_.empty()) return 0;
    std::uint32_t looked_at = 0;
    Stack stack;
    std::size_t waiting = 0;
    stack[waiting++] = root();
    while (waiting > 0) {
        const Node node = stack[--waiting];
        const FloatBox& b = box(node);
        ++looked_at;
        if (b.min.x > query.max.x || b.max.x < query.min.x || b.min.y > query.max.y ||
            b.max.y < query.min.y || b.min.z > query.max.z || b.max.z < query.min.z) {
            continue;
        }
        const Range range = below(node);
        if (node.level == 0) looked_at += static_cast<std::uint32_t>(range.end - range.first);
        for (std::size_t i = range.first; i < range.end; ++i) {
            if (node.level == 0) {
                visit(triangles_[i]);
            } else {
                stack[waiting++] = {node.level - 1, static_cast<std::uint32_t>(i)};
            }
        }
    }
    return looked_at;
}

}  // namespace snug
