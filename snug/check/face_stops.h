#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "snug/base/side.h"
#include "snug/base/vec.h"
#include "snug/base/vec2.h"
#include "snug/check/flat_drop.h"
#include "snug/check/item_lines.h"
#include "snug/check/pad_contacts.h"
#include "snug/design/foam_material.h"
#include "snug/design/stress_curve.h"

// Where an item comes to a stop on one side, with each curve that its foam may have.

namespace snug {

/// The curve as it is given, and those that the foam may have.
struct Curves {
    StressCurve given;
    std::vector<StressCurve> possible;

    explicit Curves(const FoamMaterial& foam)
        : given(foam.curve),
          possible(foam.dynamic() ? std::vector<StressCurve>{} : with_other_plateaus(foam.curve)) {}
};

constexpr double kMostThinShare = 0.1;  ///< of the energy that columns thinner than the data may take

/// One item on one axis of the case.
struct HeldItem {
    const Pads *low = nullptr, *high = nullptr;
    const Pads* low_on_stiff_base = nullptr;  ///< where it stands on islands
    double bare_low = std::numeric_limits<double>::infinity();
    double bare_high = std::numeric_limits<double>::infinity();
    const std::vector<Vec2d>* outline = nullptr;
};

[[nodiscard]] HeldItem held(const AxisContacts& all, int item);
[[nodiscard]] Cushioned towards(const HeldItem& item, bool high, double mass_kg);

/// What of a place lies across an axis, and back.
[[nodiscard]] Vec2d across(Vec3d v, int axis);
[[nodiscard]] Vec3d in_space(Vec2d across, double along, int axis);

/// Where a drop is computed: an item, a side, and what it falls onto.
struct FaceTask {
    Side face = kFloor;
    const HeldItem& item;
    const MassSpread& spread;
    Vec3d centre;
    double mass_kg = 0;
    double height_mm = 0, thin_mm = 0;

    [[nodiscard]] int axis() const { return face / 2; }
    [[nodiscard]] Cushioned cushioned() const;
    /// At the far end of the item: more than at the centre of its mass where the foam pushes beside that.
    [[nodiscard]] double g_of(const Stop& stop) const;
};

/// What an item came to with the curve as it is given, and with each that the foam may have.
struct Stops {
    std::optional<Stop> given;
    std::vector<std::optional<Stop>> possible;
    /// The same on islands whose base does not give way: the given first; empty elsewhere.
    std::vector<std::optional<Stop>> on_stiff_base;
};

[[nodiscard]] Stops stops_on(const Cushioned& item, const FaceTask& task, const Curves& curves);
/// Whether it bottoms with some curve, or on some base.
[[nodiscard]] bool may_bottom(const Stops& stops);
/// The farthest travel of stops that are all known, mm.
[[nodiscard]] double farthest(const Stops& stops);
/// As FaceShock::beyond_data has it.
[[nodiscard]] double beyond_data(const FaceTask& task, const Stops& stops, const Curves& curves);

/// Of G, at least 20 % to either side.
struct Spread {
    double low = 0;
    std::optional<double> high;  ///< none: it may bottom
};
[[nodiscard]] Spread spread_of(const FaceTask& task, const Stops& stops);

}  // namespace snug
