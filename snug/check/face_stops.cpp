#include "snug/check/face_stops.h"

#include <algorithm>
#include <cstddef>

namespace snug {
namespace {

constexpr double kLeastSpread = 0.2;  // of G to either side

/// How much more than its centre of mass the item's far end is slowed down where the foam pushes beside the
/// centre: 1 + e x / r2, with r the radius of gyration about the axis that it turns about.
double far_end(const Stop& stop, const HeldItem& item, const MassSpread& spread, Vec3d centre, int axis) {
    const Vec2d middle = across(centre, axis), off = stop.at - middle;
    const double e = length(off);
    if (!(e > 1e-9)) return 1;
    const Vec2d direction = off * (1 / e);
    double lever = 0;
    for (const Vec2d point : *item.outline) {
        const Vec2d from = point - middle;
        lever = std::max(lever, from.x * direction.x + from.y * direction.y);
    }
    const double r2 = spread.along(in_space(direction, 0, axis)) + spread.along(in_space({}, 1, axis));
    return r2 > 0 ? 1 + e * lever / r2 : 1;
}

std::vector<std::optional<Stop>> with_each(const Cushioned& item, const FaceTask& task,
                                           const std::vector<StressCurve>& curves) {
    std::vector<std::optional<Stop>> stops;
    for (const StressCurve& curve : curves)
        stops.push_back(flat_drop(item, curve, task.height_mm, task.thin_mm));
    return stops;
}

}  // namespace

HeldItem held(const AxisContacts& all, int item) {
    HeldItem found;
    for (const PadContact& contact : all.contacts) {
        const bool below = contact.high == item, above = contact.low == item;
        if (!below && !above) continue;
        if (contact.low != PadContact::kCase && contact.high != PadContact::kCase) continue;
        if (below) {
            found.low = &contact.pads;
            if (contact.on_stiff_base) found.low_on_stiff_base = &*contact.on_stiff_base;
            found.bare_low = contact.bare_mm;
        } else {
            found.high = &contact.pads;
            found.bare_high = contact.bare_mm;
        }
    }
    found.outline = &all.outlines[static_cast<std::size_t>(item)];
    return found;
}

Cushioned towards(const HeldItem& item, bool high, double mass_kg) {
    return high ? Cushioned{item.high, item.low, item.bare_high, mass_kg}
                : Cushioned{item.low, item.high, item.bare_low, mass_kg};
}

Vec2d across(Vec3d v, int axis) {
    return {v[(axis + 1) % 3], v[(axis + 2) % 3]};
}

Vec3d in_space(Vec2d across, double along, int axis) {
    Vec3d v;
    v[axis] = along;
    v[(axis + 1) % 3] = across.x;
    v[(axis + 2) % 3] = across.y;
    return v;
}

Cushioned FaceTask::cushioned() const {
    return towards(item, face % 2 == 1, mass_kg);
}

double FaceTask::g_of(const Stop& stop) const {
    return shock_g(stop, mass_kg) * far_end(stop, item, spread, centre, axis());
}

Stops stops_on(const Cushioned& item, const FaceTask& task, const Curves& curves) {
    Stops stops{flat_drop(item, curves.given, task.height_mm, task.thin_mm),
                with_each(item, task, curves.possible),
                {}};
    if (task.face == kFloor && task.item.low_on_stiff_base) {
        Cushioned stiff = item;
        stiff.ahead = task.item.low_on_stiff_base;
        stops.on_stiff_base = with_each(stiff, task, curves.possible);
        stops.on_stiff_base.insert(stops.on_stiff_base.begin(),
                                   flat_drop(stiff, curves.given, task.height_mm, task.thin_mm));
    }
    return stops;
}

bool may_bottom(const Stops& stops) {
    const auto none = [](const std::optional<Stop>& stop) { return !stop; };
    return !stops.given || std::any_of(stops.possible.begin(), stops.possible.end(), none) ||
           std::any_of(stops.on_stiff_base.begin(), stops.on_stiff_base.end(), none);
}

Spread spread_of(const FaceTask& task, const Stops& stops) {
    Spread spread{std::numeric_limits<double>::infinity(), 0};
    const auto include = [&](const std::optional<Stop>& stop, double share) {
        if (!stop) {
            spread.high.reset();
            return;
        }
        const double g = task.g_of(*stop);
        spread.low = std::min(spread.low, g * (1 - share));
        if (spread.high) spread.high = std::max(*spread.high, g * (1 + share));
    };
    include(stops.given, kLeastSpread);
    for (const auto& stop : stops.possible) include(stop, 0);
    for (std::size_t i = 0; i < stops.on_stiff_base.size(); ++i)
        include(stops.on_stiff_base[i], i == 0 ? kLeastSpread : 0);
    return spread;
}

double farthest(const Stops& stops) {
    double mm = stops.given->travel_mm;
    for (const auto& stop : stops.possible) mm = std::max(mm, stop->travel_mm);
    for (const auto& stop : stops.on_stiff_base) mm = std::max(mm, stop->travel_mm);
    return mm;
}

double beyond_data(const FaceTask& task, const Stops& stops, const Curves& curves) {
    if (!may_bottom(stops)) return stops.given->thin_share > kMostThinShare ? stops.given->thin_share : 0;
    const Cushioned item = task.cushioned();
    double lacking = lacking_share(item, curves.given, task.height_mm);
    for (const StressCurve& curve : curves.possible)
        lacking = std::max(lacking, lacking_share(item, curve, task.height_mm));
    return 1 + lacking;
}

}  // namespace snug
