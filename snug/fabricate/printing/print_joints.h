#pragma once

#include <vector>

#include "snug/base/vec.h"
#include "snug/design/print_options.h"
#include "snug/fabricate/printing/bores.h"
#include "snug/fabricate/printing/print_parts.h"

namespace snug {

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
