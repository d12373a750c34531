#pragma once

#include <vector>

#include "snug/fabricate/mill/centre_lines.h"

namespace snug {

/// A straight way of the cutter's middle; its ends may be one point.
struct CutLine {
    Vec2d from, to;
};

/// What clears one level: parallel lines along x that fill the pockets, and lines along every wall, which
/// leave no cusps between the others' ends. The cutter touches each wall exactly.
struct LevelPass {
    int level = 0;
    std::vector<CutLine> fill;
    std::vector<CutLine> walls;

    [[nodiscard]] bool empty() const { return fill.empty() && walls.empty(); }
};

/// `stepover_mm`: between neighbouring lines of the filling.
[[nodiscard]] LevelPass level_pass(const CentreLines& lines, double stepover_mm);

/// From the top down, one for each level that is cut; empty ones are left out.
[[nodiscard]] std::vector<LevelPass> level_passes(const MillField& field, double radius_mm,
                                                  double stepover_mm);

/// Diameter of the widest cutter that enters any pocket of the field, 0 where nothing is cut; to 0.1 mm.
[[nodiscard]] double widest_cutter_mm(const MillField& field);

}  // namespace snug
