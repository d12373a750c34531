#pragma once

#include <vector>

#include "snug/space/design_space.h"

namespace snug::test {

/// A triangle in design coordinates.
struct PlacedTriangle {
    Vec3d a, b, c;
};

/// The whole design space as an array of blocks: cut or foam. For tests alone: the library never makes one.
class Blocks {
  public:
    explicit Blocks(Vec3i n) : n_(n), cut_(static_cast<std::size_t>(n.x) * n.y * n.z) {}
    [[nodiscard]] bool cut(int i, int j, int k) const { return cut_[index(i, j, k)] != 0; }
    void set_cut(int i, int j, int k) { cut_[index(i, j, k)] = 1; }

  private:
    [[nodiscard]] std::size_t index(int i, int j, int k) const {
        return (static_cast<std::size_t>(i) * n_.y + j) * n_.z + k;
    }
    Vec3i n_;
    std::vector<char> cut_;
};

/// Which blocks the object cuts, straight from the definition: every triangle is clipped to every column's
/// cell grown by e, and every block of the column compared with the extremes of what is left. e = clearance -
/// 0.01, or the clearance itself with cut_on_touch, along each axis; ties are decided towards touching by
/// `touch` mm.
[[nodiscard]] Blocks brute_force_cut(const std::vector<PlacedTriangle>& triangles, const DesignSpace& space,
                                     Vec3d clearance, bool cut_on_touch, double touch = 1e-9);
[[nodiscard]] inline Blocks brute_force_cut(const std::vector<PlacedTriangle>& triangles,
                                            const DesignSpace& space, double clearance, bool cut_on_touch) {
    return brute_force_cut(triangles, space, Vec3d{clearance, clearance, clearance}, cut_on_touch);
}

}  // namespace snug::test
