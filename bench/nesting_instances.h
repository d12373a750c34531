#pragma once

#include <string>
#include <vector>

#include "snug/base/vec2.h"
#include "snug/search/mask_packer.h"

namespace snug::bench {

/// A strip-packing instance of ../shared/nesting (or of the folder that SNUG_NESTING names).
struct NestingInstance {
    struct Piece {
        std::vector<Vec2d> polygon;  ///< not closed by a doubled point
        int demand = 1;
    };
    std::string name;
    double strip_height = 0;
    bool half_turns = false;  ///< pieces may lie upside down
    std::vector<Piece> pieces;
};

/// None where the folder is absent.
[[nodiscard]] std::vector<NestingInstance> nesting_instances();

[[nodiscard]] double area_of(const NestingInstance& instance);
/// Each as often as it is wanted.
[[nodiscard]] std::vector<std::vector<Vec2d>> all_polygons(const NestingInstance& instance);
/// Grown to the whole cells that they take any part of: rows along the strip, columns across.
[[nodiscard]] MaskProblem masks_of(const NestingInstance& instance, double cell);

}  // namespace snug::bench
