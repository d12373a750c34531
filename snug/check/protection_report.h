#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/names.h"
#include "snug/base/side.h"
#include "snug/base/vec.h"
#include "snug/base/vec2.h"
#include "snug/design/drop_rules.h"
#include "snug/design/foam_material.h"
#include "snug/design/zone.h"

// What every item meets when the closed case falls flat on one of its sides, estimated from the foam behind
// each fine line through the item, the foam's stress-strain curve and the mass: an energy balance, columns of
// foam as springs of their own. ../docs/protection.md says what it is worth.

namespace snug {

/// Why a figure is missing.
enum class NoShock {
    none,
    no_foam_data,  ///< nothing is known of how the foam pushes back
    no_mass,
    no_height,  ///< heavier than the rule of the drop goes, or no drop was asked for
    open,       ///< a tray is not dropped
    unsettled,  ///< items that reach one another did not turn round in the steps that are allowed
    thin,       ///< columns thinner than the data would take over a tenth of the energy
    bottoms,    ///< the foam would be squeezed beyond its data, or the case be met
};
template <>
struct Names<NoShock> {
    static constexpr std::string_view list[] = {"",     "no_foam_data", "no_mass", "no_height",
                                                "open", "unsettled",    "thin",    "bottoms"};
};

/// How near the two ends of the foam between things came to each other, from where they are drawn: below 0
/// where they parted.
struct ContactTravel {
    int low = 0, high = 0;  ///< as PadContact has them
    double near_mm = 0;
};

/// A drop on one side, of one item.
struct FaceShock {
    Side face = kFloor;
    NoShock why_none = NoShock::none;
    /// Units of gravity: at the centre of mass with the curve as it is given; and the range of what is met at
    /// the item's far end, at least 20 % to either side. The high end is none where the foam may bottom.
    std::optional<double> g_model, g_low, g_high;
    /// How far it is from a G, to compare what has none; 0: it has one, or why not says nothing of the foam.
    /// Of thin columns their share of the energy; from 1 upward it bottoms, with what the foam to the case
    /// lacks of the energy added (lacking_share(), the most of the range).
    double beyond_data = 0;
    bool bottoms = false;         ///< with some curve of the range, on it or on what it reaches through foam
    bool bottoms_itself = false;  ///< of items that reach one another: on this one
    bool meets_item = false;      ///< another item, with some curve of the range
    /// The farthest with some curve of the range; none where it may bottom.
    std::optional<double> travel_most_mm;
    // With the curve as it is given; none where it bottoms:
    std::optional<double> travel_mm;  ///< from the drawn place, gap included
    double strain = 0;                ///< the greatest
    double peak_kpa = 0;
    Vec3d peak_at;                        ///< design coordinates
    double area_cm2 = 0;                  ///< of the foam that is squeezed
    double tilt_mm = 0;                   ///< how far beside the centre of mass the foam pushes
    std::vector<ContactTravel> contacts;  ///< all foam that the item holds or is held by, as it lay then
    /// What the foam pushes with on the way: travel in mm and newtons, with the curve as it is given, up to
    /// where its data end. Empty for items that reach one another.
    std::vector<Vec2d> force;
    /// Where what was asked for is not shown to hold: so much more foam behind it would do; none: no
    /// thickness up to 200 mm would, or it holds.
    std::optional<double> more_foam_mm;
};

/// On the lower foam.
struct RestReport {
    NoShock why_none = NoShock::none;
    double sink_mm = 0, strain = 0, peak_kpa = 0, area_cm2 = 0;
    std::vector<ContactTravel> contacts;  ///< all foam that the item holds or is held by, as it lies then
};

/// What becomes of a zone of an item.
struct ZoneReport {
    std::size_t item = 0, number = 1;  ///< numbered from 1 within its item
    Zone asked;
    Vec3d where;               ///< its middle, design coordinates
    long long cut_blocks = 0;  ///< for its sake alone
    /// Of a zone that foam keeps away from: how far it is free towards each side (by Side), see
    /// zone_room_mm(); and what is left of that after the farthest travel of the drop on it, none where that
    /// is not known.
    std::array<double, 6> room_mm{};
    std::array<std::optional<double>, 6> left_mm{};
    std::vector<Side>
        unknown;  ///< sides on which the drop may bottom, so that nothing is known of what is left
    /// Of a zone that may be pressed: the greatest mean over 1 cm2 with the curve as it is given, by Side,
    /// and at rest; none where that is not known.
    std::array<std::optional<double>, 6> press_kpa{};
    std::optional<double> rest_kpa;

    /// The side with the least left; none where nothing is known.
    [[nodiscard]] std::optional<Side> nearest() const;
    /// The most of all that is known.
    [[nodiscard]] std::optional<double> most_kpa() const;
};

/// What an item that stands on islands of foam needs beside the range of its drop.
struct IslandReport {
    bool bottoms = false;            ///< with a fifth more mass from a quarter higher
    std::optional<double> rest_kpa;  ///< the most at rest; none where that bottoms
};

struct ItemProtection {
    std::string name;  ///< of one among several; empty: it is the only one
    std::optional<double> mass_kg;
    std::optional<double> asked_g;   ///< what it is taken to bear
    Vec3d centre;                    ///< of mass, design coordinates
    bool centre_given = false;       ///< else one density is assumed
    std::array<FaceShock, 6> faces;  ///< by Side
    RestReport rest;
    /// What foam above presses on it with as it is drawn, with the curve as it is given; none: not known.
    std::optional<double> pressed_n;
    std::optional<IslandReport> relief;  ///< where it stands on islands and its drop on the floor is known
};

struct Protection {
    std::optional<double> drop_mm;
    std::optional<DropRule> rule;             ///< that the height is from
    std::optional<FragilityClass> fragility;  ///< that what the items bear is from
    std::optional<double> gross_kg;    ///< items and foam, without the case; none where a mass is missing
    bool gross_without_foam = false;   ///< the density of the foam is not known
    std::optional<FoamMaterial> foam;  ///< none: nothing is known of it
    std::vector<ItemProtection> items;
    std::vector<ZoneReport> zones;

    /// The item and face with the greatest shock for what it bears, those that bottom first.
    [[nodiscard]] std::size_t worst_item(Side face) const;
    /// The sides by what their worst item meets, the worst first.
    [[nodiscard]] std::array<Side, 6> worst_first() const;
    /// The margin of the worst item on each side.
    [[nodiscard]] std::array<double, 6> margins() const;
};

/// Where there is no G.
constexpr double kNoMargin = 1e6;
/// The high end of G for what an item bears: less is better, above 1 a face is not shown to hold. Where there
/// is no G from kNoMargin upward, more where it is farther from one; without a fragility as of 1 G.
[[nodiscard]] double margin(const ItemProtection& item, Side face);

}  // namespace snug
