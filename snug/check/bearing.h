#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "snug/base/finding.h"
#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/design/fit_options.h"
#include "snug/foam/foams.h"
#include "snug/mesh/mesh.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

namespace snug {

/// How far an object sinks into the foam before its bearing area is taken, mm.
inline constexpr std::array<double, 3> kSinking{1, 3, 5};

/// The area of each half that the object presses on once it has sunk into it, as a shadow on the y-z plane;
/// sampled on 16 x 16 lines a column (LineLattice). A line of the lower foam bears where the surface's lowest
/// point on it lies less above the foam's top than the object has sunk; the upper foam alike.
struct BearingReport {
    std::array<double, kSinking.size()> lower_mm2{};
    std::array<double, kSinking.size()> upper_mm2{};
};

/// Of what lies in `layer`, counted from 1, on whatever foam is below it and under whatever is above. Fails
/// only when cancelled.
[[nodiscard]] Result<BearingReport> bearing_report(const Mesh& mesh, const Placement& placement,
                                                   const DesignSpace& space, const Foams& foams,
                                                   int layer = 1, const Progress& progress = {});

/// What the weight of `mass_kg` presses with on an area, kPa; none on no area.
[[nodiscard]] std::optional<double> static_pressure_kpa(double mass_kg, double area_mm2);

/// A half that bears the object on nothing within 5 mm, or with more than the foam bears for long once the
/// object has sunk 5 mm: `no_bearing`, `creep` (warnings). The lower half carries the object when the case
/// stands upright, the lid when it is turned over, where there is one. `layer`: where it lies, from 1.
void find_bearing_problems(const BearingReport& bearing, const Foams& foams, int layer,
                           std::optional<double> mass_kg, const FitOptions& fit,
                           std::vector<Finding>& findings);

}  // namespace snug
