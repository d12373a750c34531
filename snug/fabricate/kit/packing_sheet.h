#pragma once

#include <vector>

#include "snug/check/fit_report.h"
#include "snug/design/workshop_options.h"
#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/mesh/mesh.h"
#include "snug/space/placement.h"

namespace snug {

/// What the packing sheet tells of.
struct PackedObject {
    const FoamDesign& design;
    const FitReport& fit;
    const std::vector<Finding>& findings;  ///< dangers first
    const Mesh& mesh;
    const Placement& placement;
    Vec3d size_mm;  ///< of the object as it was read, unturned
    const PackMaterial& material;
    const WorkshopOptions& options;
};

/// The pages that travel with the box ("packing-sheet"): how the object is laid in and lifted out, walls,
/// litres, weight, cost, findings, and what nobody has checked. Carries no date, so that equal designs make
/// equal sheets.
[[nodiscard]] DrawingDocument packing_sheet(const PackedObject& packed);

}  // namespace snug
