#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "snug/base/vec.h"

// The case that the foam is made for. Its height runs along x, its width along y and its length along z, as
// the foam lies in it: floor at -x, lid at +x, BACK at -y.

namespace snug {

/// How a material may be divided. What has a fixed pitch leaves a rest in a case.
enum class Division {
    none,    ///< blocks of one size: slit sponge, cubes, bricks
    across,  ///< sheets of a fixed thickness (x), cut to any contour in y and z
    all,     ///< printed, milled or moulded to any size
};

/// "none", "across", "all"
[[nodiscard]] std::string_view division_name(Division division);
[[nodiscard]] std::optional<Division> division_from_name(std::string_view name);

/// Width (y) and length (z) of a cross-section, mm.
struct CrossSection {
    double width = 0;
    double length = 0;
    friend bool operator==(const CrossSection&, const CrossSection&) = default;
};

struct CaseOptions {
    std::string name;                      ///< of a case in the list (cases.h), for people; may be empty
    std::optional<Vec3d> inside_mm;        ///< height, width, length inside; none: the design space is free
    double play_mm = 3;                    ///< air on each of the six sides, 0 or more
    std::optional<double> lid_mm;          ///< of the inside height, what belongs to the lid; none: not known
    double corner_radius_mm = 0;           ///< of the four upright edges
    std::optional<CrossSection> base_mm;   ///< inside at the floor, where the walls lean; none: upright
    std::optional<CrossSection> top_mm;    ///< inside at the roof of the lid; none: upright
    std::optional<double> divisor = 5000;  ///< cm3 for one kg of volumetric weight; none: a flat rate
    Division division = Division::none;    ///< of the material, as its preset says
    friend bool operator==(const CaseOptions&, const CaseOptions&) = default;
};

/// What is out of range, as a sentence: sizes that are not above the play, a lid as high as the case, corners
/// rounder than the case is wide, a case that widens away from the parting line.
[[nodiscard]] std::optional<std::string> problem_of(const CaseOptions& options);

}  // namespace snug
