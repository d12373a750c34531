#pragma once

#include <optional>
#include <string>
#include <vector>

#include "snug/drawing/drawing.h"
#include "snug/fabricate/kit/fit_test.h"
#include "snug/fabricate/sponge/pluck_plan.h"

namespace snug {

/// What the plan tells of: both halves and, where there is one, the fit test.
struct SpongeWork {
    PluckPlan lower, lid;
    std::optional<FitTest> test;
};

/// Of the document that the pages make.
[[nodiscard]] std::string sponge_title(const FoamDesign& design);

/// The pages of the plan: stock, counts and order of work in words; the overview of each half; for grids too
/// fine for numbers, tables of the depths in runs.
[[nodiscard]] std::vector<Drawing> sponge_plan(const FoamDesign& design, const SpongeWork& work,
                                               Vec2d page_mm);

}  // namespace snug
