#pragma once

#include <span>
#include <string>
#include <vector>

#include "snug/drawing/drawing.h"
#include "snug/fabricate/bricks/ldraw.h"
#include "snug/fabricate/kit/workshop_pack.h"

namespace snug {

/// What the pages tell besides the bricks.
struct BrickPlanText {
    std::string object_name;
    Language language = Language::english;
    std::vector<PackFigure> figures;
    bool closes = true;     ///< has a lid
    double lid_gap_mm = 0;  ///< that the rims' studs leave between the halves
};

/// Pages for building: the pieces to gather, the order of work, then each half course by course with the
/// pieces that it adds. The steps have the numbers that they have in ldraw_file(). Where that fills more
/// pages than anyone prints, the later courses are left out and `cut_short` is set.
struct BrickPlan {
    DrawingDocument document;
    bool cut_short = false;
};
[[nodiscard]] BrickPlan brick_plan(std::span<const ColoredBuild> halves, const BrickPlanText& text,
                                   Vec2d paper_mm);

}  // namespace snug
