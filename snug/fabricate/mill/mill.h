#pragma once

#include <optional>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/design/mill_options.h"
#include "snug/design/workshop_options.h"
#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/mesh/mesh.h"
#include "snug/space/case_space.h"
#include "snug/space/placement.h"

namespace snug {

/// An item's surface where it lies. References live as long as the packing.
struct MilledSurface {
    const Mesh& mesh;
    const Placement& placement;
    CutOptions cut;
    int layer = 1;
};

/// What foam that a round cutter leaves in corners must not reach into.
struct MilledObject {
    std::vector<MilledSurface> surfaces;     ///< one for each item
    const CaseSpace* fitted_case = nullptr;  ///< nor beyond its walls; none: the space's box alone
};

/// All pieces for a three-axis mill, each from its cavity's side and, where a case or a cavity below leaves
/// foam out there, from the other, as programs for GRBL 1.1. Fails (kind
/// usage) for options out of range, a cutter wider than every pocket or a flute shorter than a pocket is
/// deep. Without `object` no foam is left in any corner of the blocks that are cut. `page_mm`: of the set-up
/// sheet's paper.
[[nodiscard]] Result<WorkshopPack> mill_pack(const FoamDesign& design,
                                             const std::optional<MilledObject>& object,
                                             const MillOptions& options, Vec2d page_mm = paper_mm("a4"));

}  // namespace snug
