#pragma once

#include <vector>

#include "snug/base/vec.h"
#include "snug/design/print_options.h"
#include "snug/fabricate/printing/print_parts.h"

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

struct Joints {
    std::vector<Bore> bores;
    int without = 0;  ///< pairs of parts that meet where no dowel finds foam enough around it
};

/// Bores as far from each other as they can be, a few for each pair of parts that meet; none comes nearer
/// than 2 mm to a face or to another bore.
[[nodiscard]] Joints place_joints(const PrintLayout& layout, const BlockLines& lines,
                                  const PrintOptions& options);
[[nodiscard]] Joints place_joints(const PrintLayout& layout, Vec3d block_mm, const PrintOptions& options);

}  // namespace snug
