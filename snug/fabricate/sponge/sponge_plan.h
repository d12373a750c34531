#pragma once

#include <string>
#include <vector>

#include "snug/drawing/drawing.h"
#include "snug/fabricate/kit/fit_test.h"
#include "snug/fabricate/sponge/pluck_plan.h"

namespace snug {

/// What the plan tells of: all pieces, the lowest first, and the fit tests.
struct SpongeWork {
    std::vector<PluckPlan> plans;
    std::vector<LayerTest> tests;
};
[[nodiscard]] long long plucked_of(const SpongeWork& work);
[[nodiscard]] long long cut_off_of(const SpongeWork& work);

/// Of the document that the pages make.
[[nodiscard]] std::string sponge_title(const FoamDesign& design);

/// The pages of the plan: stock, counts and order of work in words; the overview of each side; for grids too
/// fine for numbers, tables of the depths in runs.
[[nodiscard]] std::vector<Drawing> sponge_plan(const FoamDesign& design, const SpongeWork& work,
                                               Vec2d page_mm);

}  // namespace snug
