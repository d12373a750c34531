#include "snug/check/face_shocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "snug/base/parallel.h"
#include "snug/check/face_stops.h"
#include "snug/check/flat_drop.h"
#include "snug/check/joint_drop.h"

namespace snug {
namespace {

constexpr double kMostMoreFoam = 200;  // mm
constexpr int kForceSteps = 40;        // of a curve that people look at
constexpr double kFoamStep = 5;        // mm, that are proposed

/// The least foam more, in steps, with which the high end of the range is what was asked for.
std::optional<double> more_foam(const FaceTask& task, const Curves& curves, double asked_g) {
    const Cushioned item = task.cushioned();
    if (!item.ahead || std::isfinite(item.bare_mm) || task.item.low_on_stiff_base) return {};
    const auto holds = [&](int steps) {
        const Pads thicker = item.ahead->thicker(steps * kFoamStep);
        Cushioned on_it = item;
        on_it.ahead = &thicker;
        const Stops stops = stops_on(on_it, task, curves);
        const Spread spread = spread_of(task, stops);
        return spread.high && *spread.high <= asked_g && stops.given->thin_share <= kMostThinShare;
    };
    int fails = 0, does = static_cast<int>(kMostMoreFoam / kFoamStep);
    if (!holds(does)) return {};
    while (does - fails > 1) {
        const int middle = (fails + does) / 2;
        (holds(middle) ? does : fails) = middle;
    }
    return does * kFoamStep;
}

FaceShock shock_of(const FaceTask& task, const Stops& stops, const Curves& curves, const Box3d& bounds) {
    FaceShock shock;
    shock.face = task.face;
    const auto& stop = stops.given;
    const Spread spread = spread_of(task, stops);
    shock.bottoms = !spread.high;
    shock.beyond_data = beyond_data(task, stops, curves);
    if (spread.high) shock.travel_most_mm = farthest(stops);
    if (stop) {
        const double end = task.face % 2 == 1 ? bounds.max[task.axis()] : bounds.min[task.axis()];
        shock.travel_mm = stop->travel_mm;
        shock.strain = stop->strain;
        shock.peak_kpa = stop->peak_kpa;
        shock.peak_at = in_space(stop->most_at, end, task.axis());
        shock.area_cm2 = stop->area_mm2 * 1e-2;
        shock.tilt_mm = length(stop->at - across(task.centre, task.axis()));
        shock.contacts = stop->contacts;
    }
    if (!stop)
        shock.why_none = NoShock::bottoms;
    else if (stop->thin_share > kMostThinShare)
        shock.why_none = NoShock::thin;
    if (shock.why_none == NoShock::none) {
        shock.g_model = shock_g(*stop, task.mass_kg);
        shock.g_low = spread.low;
        shock.g_high = spread.high;
    }
    return shock;
}

bool holds(const FaceShock& shock, double asked_g) {
    return shock.g_high && *shock.g_high <= asked_g;
}

/// Of an item between foams of the case alone.
std::vector<ContactTravel> alone_between(std::size_t item, int side, double travel_mm) {
    const int own = static_cast<int>(item);
    const double low_mm = side % 2 == 0 ? travel_mm : -travel_mm;
    return {{PadContact::kCase, own, low_mm}, {own, PadContact::kCase, -low_mm}};
}

RestReport rest_of(const std::optional<Stop>& stop) {
    RestReport rest;
    if (!stop) {
        rest.why_none = NoShock::bottoms;
        return rest;
    }
    rest.sink_mm = stop->travel_mm;
    rest.strain = stop->strain;
    rest.peak_kpa = stop->peak_kpa;
    rest.area_cm2 = stop->area_mm2 * 1e-2;
    rest.contacts = stop->contacts;
    return rest;
}

/// A fifth more mass from a quarter higher must not bottom where islands alone carry it, and at rest they
/// press more than a flat block would.
IslandReport relief_of(FaceTask task, const Curves& curves) {
    IslandReport relief;
    Cushioned item = task.cushioned();
    for (const Pads* pads : {item.ahead, task.item.low_on_stiff_base}) {
        item.ahead = pads;
        const auto rest = at_rest(item, curves.given);
        if (!rest) return {true, {}};
        relief.rest_kpa = std::max(relief.rest_kpa.value_or(0), rest->peak_kpa);
    }
    task.mass_kg *= 1.2;
    task.height_mm *= 1.25;
    relief.bottoms = may_bottom(stops_on(task.cushioned(), task, curves));
    return relief;
}

/// What the items of a packing meet along an axis.
class AxisDrops {
  public:
    AxisDrops(const AxisContacts& contacts, const Packing& packing, const Curves& curves, FaceDetail detail,
              Protection& all)
        : contacts_(contacts), packing_(packing), curves_(curves), detail_(detail), all_(all) {}

    void add() {
        for (const std::vector<int>& set : joint_sets(contacts_.contacts, all_.items.size()))
            if (set.size() == 1)
                add_alone(static_cast<std::size_t>(set.front()));
            else
                add_joint(set);
    }

  private:
    [[nodiscard]] FaceTask task_of(std::size_t i, int side, const HeldItem& held) const {
        const ItemProtection& item = all_.items[i];
        return {static_cast<Side>(side), held,          contacts_.spreads[i],           item.centre,
                *item.mass_kg,           *all_.drop_mm, all_.foam->least_thickness_mm()};
    }

    [[nodiscard]] std::array<int, 2> sides() const { return {2 * contacts_.axis, 2 * contacts_.axis + 1}; }

    void add_alone(std::size_t i) {
        ItemProtection& item = all_.items[i];
        const HeldItem found = held(contacts_, static_cast<int>(i));
        if (contacts_.axis == 0 && item.mass_kg && detail_ == FaceDetail::all) {
            item.rest = rest_of(at_rest(towards(found, false, *item.mass_kg), curves_.given));
            item.rest.contacts = alone_between(i, kFloor, item.rest.sink_mm);
        }
        for (const int side : sides()) {
            FaceShock& face = item.faces[static_cast<std::size_t>(side)];
            face.why_none = obstacle(all_, item, packing_);
            if (face.why_none != NoShock::none) continue;
            const FaceTask task = task_of(i, side, found);
            face = shock_of(task, stops_on(task.cushioned(), task, curves_), curves_,
                            packing_.items[i].placement.bounds);
            face.bottoms_itself = face.bottoms;
            if (detail_ == FaceDetail::shock) continue;
            if (face.travel_mm) face.contacts = alone_between(i, side, *face.travel_mm);
            face.force = force_on_the_way(task.cushioned(), curves_.given, kForceSteps);
            if (side == kFloor && found.low_on_stiff_base) item.relief = relief_of(task, curves_);
            // Where nothing was asked it must not bottom, at least.
            const double asked_g = item.asked_g.value_or(std::numeric_limits<double>::infinity());
            if (!holds(face, asked_g)) face.more_foam_mm = more_foam(task, curves_, asked_g);
        }
    }

    [[nodiscard]] JointItems joint(const std::vector<int>& set, bool to_high) const {
        JointItems items{set, {}, {}, to_high};
        for (const int item : set)
            items.mass_kg.push_back(*all_.items[static_cast<std::size_t>(item)].mass_kg);
        const auto is_in = [&](int item) {
            return item == PadContact::kCase || std::find(set.begin(), set.end(), item) != set.end();
        };
        for (const PadContact& contact : contacts_.contacts)
            if (is_in(contact.low) && is_in(contact.high)) items.contacts.push_back(&contact);
        return items;
    }

    void add_joint(const std::vector<int>& set) {
        NoShock obstacle_of_any = NoShock::none;
        bool weighed = true;
        for (const int item : set) {
            const ItemProtection& each = all_.items[static_cast<std::size_t>(item)];
            weighed = weighed && each.mass_kg;
            const NoShock why = obstacle(all_, each, packing_);
            if (why != NoShock::none) obstacle_of_any = why;
        }
        if (contacts_.axis == 0 && weighed) {
            const JointStops rest = joint_rest(joint(set, false), curves_.given);
            for (std::size_t k = 0; k < set.size(); ++k)
                all_.items[static_cast<std::size_t>(set[k])].rest = rest_of(rest.stops[k]);
        }
        if (!weighed)
            for (const int item : set)
                all_.items[static_cast<std::size_t>(item)].rest.why_none = NoShock::no_mass;
        for (const int side : sides())
            if (obstacle_of_any == NoShock::none)
                add_joint_side(set, side);
            else
                for (const int item : set)
                    all_.items[static_cast<std::size_t>(item)]
                        .faces[static_cast<std::size_t>(side)]
                        .why_none = obstacle_of_any;
    }

    void add_joint_side(const std::vector<int>& set, int side) {
        const JointItems items = joint(set, side % 2 == 1);
        std::vector<JointStops> by_curve(1 + curves_.possible.size());
        parallel_for(by_curve.size(), [&](std::size_t i) {
            by_curve[i] = joint_drop(items, i == 0 ? curves_.given : curves_.possible[i - 1], *all_.drop_mm,
                                     all_.foam->least_thickness_mm());
        });
        const bool unsettled = std::any_of(by_curve.begin(), by_curve.end(),
                                           [](const JointStops& each) { return each.unsettled; });
        for (std::size_t k = 0; k < set.size(); ++k) {
            const auto i = static_cast<std::size_t>(set[k]);
            Stops stops{by_curve.front().stops[k], {}, {}};
            for (std::size_t curve = 1; curve < by_curve.size(); ++curve)
                stops.possible.push_back(by_curve[curve].stops[k]);
            const HeldItem found = held(contacts_, set[k]);
            FaceShock& face = all_.items[i].faces[static_cast<std::size_t>(side)];
            if (unsettled) {
                face.why_none = NoShock::unsettled;
                face.beyond_data = 1;
                continue;
            }
            face = shock_of(task_of(i, side, found), stops, curves_, packing_.items[i].placement.bounds);
            for (const JointStops& each : by_curve) {
                face.meets_item = face.meets_item || (each.items_meet && each.bottoms[k]);
                face.bottoms_itself = face.bottoms_itself || each.bottoms[k];
            }
        }
    }

    const AxisContacts& contacts_;
    const Packing& packing_;
    const Curves& curves_;
    FaceDetail detail_;
    Protection& all_;
};

}  // namespace

NoShock obstacle(const Protection& all, const ItemProtection& item, const Packing& packing) {
    if (packing.foams->open()) return NoShock::open;
    if (!all.foam || all.foam->curve.empty()) return NoShock::no_foam_data;
    if (!item.mass_kg) return NoShock::no_mass;
    return all.drop_mm ? NoShock::none : NoShock::no_height;
}

void add_face_shocks(const AxisContacts& contacts, const Packing& packing, const Curves& curves,
                     Protection& all, FaceDetail detail) {
    AxisDrops(contacts, packing, curves, detail, all).add();
}

}  // namespace snug
