#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "snug/base/box.h"
#include "snug/check/fit_report.h"
#include "snug/check/protection_report.h"
#include "snug/design/workshop_options.h"
#include "snug/fabricate/kit/packing_picture.h"
#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/foam/fill_pads.h"
#include "snug/foam/lift_slots.h"
#include "snug/mesh/mesh.h"
#include "snug/space/case_space.h"
#include "snug/space/placement.h"

namespace snug {

/// A line of what lies in the box. References live as long as the objects and the packing.
struct PackedItem {
    std::string name;  ///< as people know it
    Vec3d size_mm;     ///< of its object as it was read, unturned
    std::optional<double> mass_kg;
    const Mesh& mesh;
    const Placement& placement;
    int layer = 1;
    std::vector<Box3d> zones{};  ///< where it may not be touched, design coordinates
};

/// What the packing sheet tells of.
struct PackedObject {
    const FoamDesign& design;
    const FitReport& fit;
    const std::vector<Finding>& findings;  ///< dangers first
    std::vector<PackedLayer> layers;       ///< the lowest first
    std::vector<PackedItem> items;         ///< one at least
    const PackMaterial& material;
    const WorkshopOptions& options;
    std::span<const LiftSlot> lift;  ///< to lift pieces by
    const FillPads& pads;
    const std::optional<Protection>& protection;
    const std::optional<CaseSpace>& fitted_case;
};

/// The pages that travel with the box ("packing-sheet"): how the object is laid in and lifted out, walls,
/// litres, weight, cost, findings, and what nobody has checked. Carries no date, so that equal designs make
/// equal sheets.
[[nodiscard]] DrawingDocument packing_sheet(const PackedObject& packed);

}  // namespace snug
