#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "snug/base/vec.h"

namespace snug {

/// Two opposite recesses of the lower foam beside the object, for the fingers that lift it. Lengths in mm,
/// cut in whole blocks.
struct NotchOptions {
    double width_mm = 80;             ///< along the object's side
    double depth_mm = 40;             ///< below the parting level
    double room_mm = 25;              ///< from the object outwards
    std::optional<int> axis;          ///< that leads from one to the other: 1 (y), 2 (z); none: chosen
    std::optional<double> first_mm;   ///< middle of the one at -y or -z along the other axis; none: chosen
    std::optional<double> second_mm;  ///< middle of the opposite one; none: chosen
    friend bool operator==(const NotchOptions&, const NotchOptions&) = default;
};

/// What makes the cut foam one to work and live with.
struct FitOptions {
    double least_rib_mm = 0;              ///< foam between cavities that is thinner is cut away; 0: none is
    std::optional<NotchOptions> notches;  ///< none: no recesses
    std::optional<double> creep_kpa;      ///< pressure that the foam bears for long, above 0; none: not known
    friend bool operator==(const FitOptions&, const FitOptions&) = default;
};

/// What is out of range, as a sentence; none where all is well.
[[nodiscard]] std::optional<std::string> problem_of(const FitOptions& options);

}  // namespace snug
