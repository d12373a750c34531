#pragma once

#include <span>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/check/packing.h"
#include "snug/design/project.h"
#include "snug/fabricate/bricks/linear_program.h"
#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/object/object.h"
#include "snug/words/words.h"

// From a packing to what a maker takes to the workshop:
//
//   packing + options --the pack of its way of working--> files, maps, figures
//                     --material----------------------> litres, kilograms, cost
//                     --packing sheet-----------------> the page that travels with the box

namespace snug {

/// What only some builds have, and what long work tells.
struct WorkshopTools {
    LpSolver solve_lp;  ///< none: the bricks' strength is not checked, and the pack says so
    Progress progress;  ///< of that check
    Language language = Language::english;  ///< of pages and pictures
};

/// The pack that the project's design asks for, with the packing sheet as its last document and the
/// material's figures filled in and, as lines for people, at the end of `figures`. Fails with kind `usage`
/// where the design asks for no pack or for one that its foams do not allow.
[[nodiscard]] Result<WorkshopPack> workshop_pack(std::span<const Object> objects, const Packing& packing,
                                                 const Project& project, const WorkshopTools& tools = {});

}  // namespace snug
