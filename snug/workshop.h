#pragma once

#include "snug/base/result.h"
#include "snug/design/project.h"
#include "snug/fabricate/workshop_pack.h"
#include "snug/pipeline.h"

// From a packing to what a maker takes to the workshop:
//
//   packing + options --the pack of its way of working--> files, maps, figures
//                     --material----------------------> litres, kilograms, cost
//                     --packing sheet-----------------> the page that travels with the box

namespace snug {

/// The pack that the project's design asks for, with the packing sheet as its last document and the
/// material's figures filled in and, as lines for people, at the end of `figures`. Fails with kind `usage`
/// where the design asks for no pack or for one that its foams do not allow.
[[nodiscard]] Result<WorkshopPack> workshop_pack(const Object& object, const Packing& packing,
                                                 const Project& project);

}  // namespace snug
