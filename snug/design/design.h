#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/design/case_options.h"
#include "snug/design/clean_options.h"
#include "snug/design/clearance.h"
#include "snug/design/fit_options.h"
#include "snug/design/search_options.h"
#include "snug/design/walls.h"
#include "snug/design/workshop_options.h"

// Everything that a user chooses, one struct for each stage of the method, with its default beside each
// field.

namespace snug {

/// Limits of what may be asked for.
constexpr int kMostBlocks = 4096;
constexpr double kLeastBlockSize = 0.1;        // mm
constexpr double kGreatestBlockSize = 10000;   // mm
constexpr double kLeastClearanceShare = -0.4;  // of the smallest block side
constexpr double kGreatestLength = 1e6;        // mm: offsets, walls, clearances

enum class Unit { mm, cm, m, in };
[[nodiscard]] double millimetres(Unit unit);
[[nodiscard]] std::string_view unit_name(Unit unit);
[[nodiscard]] std::optional<Unit> unit_from_name(std::string_view name);

struct ObjectOptions {
    std::optional<Unit> units;         ///< of the file; not chosen: mm, if the size is plausible
    double scale = 1;                  ///< on top of the unit, > 0
    std::optional<double> longest_mm;  ///< scales the longest side to this instead of units and scale
    bool cap = false;                  ///< span the holes of an open object
    double point_radius_mm = 0;        ///< of a cloud's points; 0: from their spacing
    CleanOptions clean;
    friend bool operator==(const ObjectOptions&, const ObjectOptions&) = default;
};

struct SpaceOptions {
    std::string preset = "paper";                     ///< the foam's name, see presets.h
    std::optional<Vec3i> blocks = Vec3i{30, 18, 18};  ///< 1 to 4096 an axis; none: the object plus walls
    Vec3d block_mm{15, 15, 22};                       ///< 0.1 to 10,000 an axis
    std::optional<Walls> wall_mm;  ///< least foam on each side; none: 50 where the space is fitted
    friend bool operator==(const SpaceOptions&, const SpaceOptions&) = default;
};

struct PlacementOptions {
    Vec3d rotation_deg;  ///< Euler angles psi, theta, phi about the fixed axes x, then y, then z
    Vec3d offset_mm;     ///< from the centre of the space
    friend bool operator==(const PlacementOptions&, const PlacementOptions&) = default;
};

struct CutOptions {
    Clearance clearance_mm;  ///< the object is grown by this
    /// The paper's literal "overlap or touch": blocks that only touch are cut too.
    bool cut_on_touch = false;
    double liner_mm = 0;  ///< of a cloth or film between object and foam, on top of the clearance, 0 or more
    /// Of the studs that stand into the cavity from both halves, on top of the clearance along x. Follows
    /// from the way of working: checked() sets it.
    double stud_mm = 0;

    /// With liner and studs; from -0.4 of the smallest block side upward.
    [[nodiscard]] Clearance whole_clearance_mm() const {
        const Clearance lined = clearance_mm + liner_mm;
        const Vec3d studs{stud_mm, 0, 0};
        return {lined.lower + studs, lined.upper + studs};
    }
    friend bool operator==(const CutOptions&, const CutOptions&) = default;
};

struct PartingOptions {
    std::optional<int> level;  ///< lower blocks where the object does not touch, 0 to nx; none: chosen
    friend bool operator==(const PartingOptions&, const PartingOptions&) = default;
};

struct OutputOptions {
    std::vector<std::string> formats{"stl", "ply"};  ///< of the foams
    friend bool operator==(const OutputOptions&, const OutputOptions&) = default;
};

struct Design {
    ObjectOptions object;
    SpaceOptions space;
    PlacementOptions placement;
    CutOptions cut;
    PartingOptions parting;
    OutputOptions output;
    CaseOptions case_options;
    FitOptions fit;
    SearchOptions search;
    WorkshopOptions workshop;
    friend bool operator==(const Design&, const Design&) = default;
};

/// The walls that the design asks for: the chosen ones, or 50 mm (the usual least for parcels) where the
/// space is fitted to the object, or none.
[[nodiscard]] Walls wanted_wall_mm(const SpaceOptions& space);

/// The design with what follows from its other choices filled in, or the first thing that is out of range, as
/// an Error of kind `usage`.
[[nodiscard]] Result<Design> checked(Design design);

}  // namespace snug
