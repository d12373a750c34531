#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "snug/base/box.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// Cubes along the longest side that make a good stand-in for an object: some 400,000 triangles.
inline constexpr int kStandInCubes = 192;

/// Which cubes of a grid an object's surface meets: what can be kept of an object of any size, to look at and
/// to search with. Marking is safe from several threads, and the order of marks does not matter.
class MetCubes {
  public:
    /// At most `most` (1 to 1024) cubes along the longest side of the box, which must not be empty. What is
    /// marked must lie in it.
    MetCubes(const Box3d& box, int most);

    /// All cubes that a box meets.
    void mark(const Box3d& box);
    /// The same, if those are at most 2 x 2 x 2; otherwise nothing is marked and the result is false.
    bool mark_if_small(const Box3d& box);
    /// All cubes that a triangle meets, and some beside them.
    void mark(const std::array<Vec3d, 3>& corners);

    [[nodiscard]] double side() const { return side_; }

    /// A closed surface around all marked cubes, at most three of their sides away from them, by surface nets
    /// (Gibson, Constrained Elastic Surface Nets, 1998) around the cubes and their neighbours. So it is never
    /// inside what was marked: whatever holds it holds the object. Hollow where the object's surface is far
    /// from itself.
    [[nodiscard]] Mesh shell() const;

  private:
    struct Cell {
        int i = 0, j = 0, k = 0;
    };
    [[nodiscard]] Cell cell_of(Vec3d p) const;
    void mark(Cell first, Cell last);

    Vec3d start_;
    double side_;
    double cubes_per_mm_ = 1;
    Cell count_;
    std::size_t words_;  ///< of 64 cubes each, along z
    std::vector<std::atomic<std::uint64_t>> marked_;
};

}  // namespace snug
