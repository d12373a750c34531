#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace snug {

/// Where the program's X0 Y0 lies on the stock; Z0 is always its top.
enum class MillOrigin { corner, centre };
[[nodiscard]] std::string_view mill_origin_name(MillOrigin origin);  ///< corner, centre
[[nodiscard]] std::optional<MillOrigin> mill_origin_from_name(std::string_view name);

/// Foam milled with a flat cutter. Lengths in mm. Feeds and speeds are starting values: no maker's table
/// covers soft foams.
struct MillOptions {
    double cutter_mm = 6;                ///< diameter, 0.5 to 100
    double flute_mm = 60;                ///< how deep the cutter can go, 1 to 1000
    std::optional<double> step_down_mm;  ///< the most that one pass goes down; none: half the cutter
    double stepover = 0.4;               ///< between neighbouring paths, share of the diameter, 0.05 to 0.9
    double feed_mm_min = 1500;           ///< 1 to 50,000
    double plunge_mm_min = 400;          ///< 1 to 50,000
    double spindle_rpm = 16000;          ///< 1 to 100,000
    double safe_mm = 5;                  ///< above the stock, for rapid moves; 0.5 to 200
    double pin_mm = 6;                   ///< diameter of the registration pins, 1 to 50; 0: none
    MillOrigin origin = MillOrigin::corner;
    friend bool operator==(const MillOptions&, const MillOptions&) = default;
};

/// What is out of range whatever the foam is, as a sentence; none where all is well.
[[nodiscard]] std::optional<std::string> problem_of(const MillOptions& options);

}  // namespace snug
