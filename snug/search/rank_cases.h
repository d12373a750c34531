#pragma once

#include <array>
#include <optional>
#include <vector>

#include "snug/base/vec.h"
#include "snug/design/cases.h"
#include "snug/design/design.h"

namespace snug {

/// A way to lay a box: which of its axes comes to lie along x, y and z of the case.
using Lay = std::array<int, 3>;
/// As it is first, then the ways that need one quarter turn, then the others.
constexpr std::array<Lay, 6> kLays{{{0, 1, 2}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}}};

/// What is to go into a case.
struct Cargo {
    Vec3d size_mm;                  ///< of the object as placed
    std::optional<double> mass_kg;  ///< of the object; foam is light and not counted
    double divisor = 5000;          ///< cm3 for one kg, where a carton or hard case does not say its own
};

struct RankedCase {
    KnownCase known;
    Lay lay{0, 1, 2};
    double fill = 0;                     ///< object with clearance and walls / inside without play, 0 to 1
    std::optional<double> billed_kg;     ///< the greater of mass and volumetric weight, whole kg
    std::array<double, 3> lacking_mm{};  ///< along x, y, z; all 0 where it fits
    [[nodiscard]] double lacking() const { return lacking_mm[0] + lacking_mm[1] + lacking_mm[2]; }
};

struct CaseRanking {
    std::vector<RankedCase> fitting;    ///< best fill first, then least billed weight, then least price
    std::optional<RankedCase> nearest;  ///< where none fits: the one that lacks least
    Vec3d least_inside_mm;              ///< height, width, length that the object needs as it is placed
    std::vector<KnownCase> too_weak;    ///< fit, but may not be as heavy
};

/// Looks at each case with the design's play, material, clearance and walls, and at all ways to lay the
/// object's three axes in it.
[[nodiscard]] CaseRanking rank_cases(const std::vector<KnownCase>& known, const Design& design,
                                     const Cargo& cargo);

/// The rotation that lays the object this way, where it is turned already: Euler angles, degrees.
[[nodiscard]] Vec3d rotation_for(const Lay& lay, Vec3d rotation_deg);

/// What a carrier bills: the greater of the mass and the volumetric weight, rounded up to whole kg; none
/// where neither is known. Reckoned from the inside sizes, so at least this.
[[nodiscard]] std::optional<double> billed_kg(const KnownCase& known, const Cargo& cargo);

}  // namespace snug
