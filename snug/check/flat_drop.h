#pragma once

#include <optional>
#include <vector>

#include "snug/base/vec2.h"
#include "snug/check/pad_contacts.h"
#include "snug/check/protection_report.h"
#include "snug/design/stress_curve.h"

namespace snug {

/// An item between the foams of two opposite sides, of which it falls onto the first.
struct Cushioned {
    const Pads* ahead = nullptr;   ///< that it is pressed into; none: no foam at all
    const Pads* behind = nullptr;  ///< counts while it is squeezed as drawn; may be none
    double bare_mm = 0;  ///< the way until something meets the case itself; infinite where foam lies
    double mass_kg = 0;
};

/// Where an item came to rest, or turned back.
struct Stop {
    double travel_mm = 0;  ///< from the drawn place
    double newton = 0;     ///< what the foam pushes with, that behind subtracted
    Vec2d at;              ///< where that acts, across the way
    double strain = 0;     ///< of the most squeezed column
    Vec2d most_at;         ///< where that stands
    double peak_kpa = 0;
    double area_mm2 = 0;    ///< of the foam that is squeezed
    double thin_share = 0;  ///< of the energy that columns thinner than the data took up
    /// Of items that reach one another: how all foam beside this one lay. Else the travel tells.
    std::vector<ContactTravel> contacts;
};

/// The case falls flat from `height_mm` and stops at once: the energy balance m g (h + d) = what the foam
/// takes up on the way d, the whole gap fallen through. None where that would squeeze a column beyond the
/// curve's last point, or meet the case. `thin_mm`: what thin means.
[[nodiscard]] std::optional<Stop> flat_drop(const Cushioned& item, const StressCurve& curve, double height_mm,
                                            double thin_mm);

/// Of the energy of such a fall the share that the foam cannot take up, as far as its data go and the case is
/// not met: 0 where it stops the item, 1 where there is no foam.
[[nodiscard]] double lacking_share(const Cushioned& item, const StressCurve& curve, double height_mm);

/// At rest: m g = F(d). None as above.
[[nodiscard]] std::optional<Stop> at_rest(const Cushioned& item, const StressCurve& curve);

/// Travel in mm and the newtons that the foam pushes with there, `steps` + 1 points from the drawn place to
/// where the data end or the case is met.
[[nodiscard]] std::vector<Vec2d> force_on_the_way(const Cushioned& item, const StressCurve& curve, int steps);

/// What a stop is felt as, in units of gravity: (F - m g) / (m g).
[[nodiscard]] double shock_g(const Stop& stop, double mass_kg);

}  // namespace snug
