#pragma once

#include <cstdint>
#include <vector>

#include "snug/base/vec.h"
#include "snug/design/print_options.h"

// Blind bores for dowels, as every part that is printed has them: a square opening in a flat face, in it the
// mouth of a prism that stands for the bore, and the prism's wall and end. Parts have levels, y and z.

namespace snug {

constexpr int kBoreSides = 16;  ///< of the prism that stands for a bore, and of a printed dowel

/// A place where a dowel joins two parts: a blind bore in both, of one size.
struct Bore {
    int axis = 0;     ///< that it runs along: 0 levels, 1 y, 2 z
    int plane = 0;    ///< the block line of the cut
    Vec3d centre_mm;  ///< on the cut; from the half's first corner, levels first
    int before = 0;   ///< the part that ends at the cut
    int after = 0;    ///< the part that begins there
};

/// Of a bore: the circle within its prism leaves the clearance around a dowel.
[[nodiscard]] double bore_corner_radius_mm(const PrintOptions& options);
/// Into each of the two parts.
[[nodiscard]] double bore_depth_mm(const PrintOptions& options);
/// Of foam that a bore takes from one part, in mm3.
[[nodiscard]] double bore_volume_mm3(const PrintOptions& options);

/// The axes in the plane of a cut across an axis: that of its rows and that of its positions.
struct PlaneAxes {
    int row, position;
};
[[nodiscard]] constexpr PlaneAxes plane_axes(int axis) {
    if (axis == 0) return {1, 2};
    return axis == 1 ? PlaneAxes{2, 0} : PlaneAxes{1, 0};
}

/// The kBoreSides corners of a bore's prism in the plane of its cut, from rows towards positions.
[[nodiscard]] std::vector<Vec3d> bore_ring(int axis, Vec3d centre_mm, double corner_radius_mm);

/// Where a bore's vertices stand: the corners of its opening (at the beginning of rows and positions, at the
/// end of positions, at the end of rows, at the end of both), its ring in the face and its ring at the end.
struct BoreVertices {
    std::uint32_t opening = 0, mouth = 0, end = 0;
};

/// Fills the opening around the mouth and closes the bore. `after`: the part begins at the cut.
void add_bore(const BoreVertices& at, int axis, bool after, std::vector<Triangle>& triangles);

}  // namespace snug
