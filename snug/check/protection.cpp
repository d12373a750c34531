#include "snug/check/protection.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "snug/base/parallel.h"
#include "snug/base/text.h"
#include "snug/check/face_shocks.h"
#include "snug/check/find_shocks.h"
#include "snug/check/item_lines.h"
#include "snug/check/pad_contacts.h"
#include "snug/check/stability.h"
#include "snug/check/zones_in_drops.h"
#include "snug/design/presets.h"
#include "snug/object/zone_surface.h"

namespace snug {
namespace {

/// The gross mass of the pack without its case.
std::optional<double> gross_kg(const Packing& packing, const std::optional<double>& density) {
    double sum = packing.fit.foam_mm3 * 1e-9 * density.value_or(0);
    for (const Item& item : packing.items) {
        if (!item.mass_kg) return {};
        sum += *item.mass_kg;
    }
    return sum;
}

ItemProtection begun(const Object& object, const Item& item, const ItemOptions& own, const Design& design) {
    ItemProtection all;
    all.mass_kg = item.mass_kg;
    all.asked_g = own.fragility_g ? own.fragility_g : design.protection.asked_g();
    all.centre_given = own.centre_mm || design.protection.centre_mm;
    all.centre = mass_centre(object, item, own, design);
    if (!item.mass_kg) all.rest.why_none = NoShock::no_mass;
    for (int i = 0; i < 6; ++i) all.faces[static_cast<std::size_t>(i)].face = static_cast<Side>(i);
    return all;
}

/// What is known before anything is computed.
Protection begun(std::span<const Object> objects, const Packing& packing, const Design& design) {
    const ProtectionOptions& options = design.protection;
    Protection all;
    all.foam = options.foam;
    std::optional<double> density = design.workshop.density_kg_m3;
    if (!density && all.foam && !is_rigid(design)) density = all.foam->density_kg_m3;
    all.gross_without_foam = !density;
    all.gross_kg = gross_kg(packing, density);
    all.rule = options.rule;
    all.fragility = options.fragility;
    all.drop_mm = options.height_mm;
    if (options.rule && all.gross_kg) all.drop_mm = drop_height_mm(*options.rule, *all.gross_kg);
    for (std::size_t i = 0; i < packing.items.size(); ++i)
        all.items.push_back(
            begun(objects[packing.items[i].object], packing.items[i], design.items[i], design));
    if (packing.items.size() > 1)
        for (std::size_t i = 0; i < packing.items.size(); ++i) all.items[i].name = packing.items[i].name;
    return all;
}

bool any_zones(const Design& design) {
    return std::any_of(design.items.begin(), design.items.end(),
                       [&](const ItemOptions& item) { return !zones_of(item, design).empty(); });
}

/// What holds the items along each axis; the axes are worked out side by side.
Result<std::vector<AxisContacts>> contacts_by_axis(std::span<const Object> objects, const Packing& packing,
                                                   const Progress& progress) {
    std::vector<std::optional<Result<AxisContacts>>> found(3);
    std::mutex telling;
    std::array<double, 3> done{};
    parallel_for(found.size(), [&](std::size_t axis) {
        const auto told = [&](double share) {
            const std::lock_guard lock(telling);
            done[axis] = share;
            return go_on(progress, (done[0] + done[1] + done[2]) / 3);
        };
        auto lines = axis_lines(objects, packing.items, packing.space, static_cast<int>(axis), told);
        if (lines)
            found[axis] = pad_contacts(*lines, packing, packing.pockets);
        else
            found[axis] = tl::unexpected(lines.error());
    });
    std::vector<AxisContacts> contacts;
    for (auto& each : found) {
        if (!*each) return tl::unexpected(each->error());
        contacts.push_back(std::move(**each));
    }
    return contacts;
}

void add_pressing(const AxisContacts& contacts, const Curves& curves, Protection& all) {
    if (contacts.axis != 0) return;
    for (ItemProtection& item : all.items) item.pressed_n = 0;
    for (const PadContact& contact : contacts.contacts)
        if (contact.low != PadContact::kCase)
            *all.items[static_cast<std::size_t>(contact.low)].pressed_n +=
                contact.pads.push(0, curves.given).newton;
}

/// What a shock is for what the item bears; infinite where the foam may bottom.
double badness(const ItemProtection& item, Side face) {
    const FaceShock& shock = item.faces[static_cast<std::size_t>(face)];
    if (shock.bottoms) return std::numeric_limits<double>::infinity();
    return shock.g_high.value_or(0) / item.asked_g.value_or(1);
}

/// By a rule a heavy pack falls from less high, also where the foam makes it heavy.
void find_lighter_fall(const Protection& all, std::vector<Finding>& findings) {
    if (!all.rule || !all.gross_kg || !all.drop_mm) return;
    double items_kg = 0;
    for (const ItemProtection& item : all.items) items_kg += item.mass_kg.value_or(0);
    const auto alone_mm = drop_height_mm(*all.rule, items_kg);
    if (!alone_mm || *alone_mm <= *all.drop_mm) return;
    const double foam_kg = *all.gross_kg - items_kg;
    findings.push_back({foam_kg > items_kg ? Severity::warning : Severity::note,
                        say("falls_less", {{"foam_kg", number(foam_kg, 1)},
                                           {"rule", title_of(*all.rule)},
                                           {"low", number(*all.drop_mm, 0)},
                                           {"high", number(*alone_mm, 0)}})});
    sort_by_severity(findings);
}

}  // namespace

std::size_t Protection::worst_item(Side face) const {
    std::size_t worst = 0;
    for (std::size_t i = 1; i < items.size(); ++i)
        if (badness(items[i], face) > badness(items[worst], face)) worst = i;
    return worst;
}

double margin(const ItemProtection& item, Side face) {
    const FaceShock& shock = item.faces[static_cast<std::size_t>(face)];
    if (!shock.g_high) return kNoMargin * (1 + shock.beyond_data);
    return std::min(*shock.g_high / item.asked_g.value_or(1), kNoMargin);
}

std::array<double, 6> Protection::margins() const {
    std::array<double, 6> worst{};
    for (const ItemProtection& item : items)
        for (int side = 0; side < 6; ++side) {
            double& most = worst[static_cast<std::size_t>(side)];
            most = std::max(most, margin(item, static_cast<Side>(side)));
        }
    return worst;
}

std::array<Side, 6> Protection::worst_first() const {
    std::array<Side, 6> sides{kFloor, kRoof, kBack, kFront, kLeft, kRight};
    const auto worst_on = [&](Side side) { return badness(items[worst_item(side)], side); };
    std::stable_sort(sides.begin(), sides.end(), [&](Side a, Side b) { return worst_on(a) > worst_on(b); });
    return sides;
}

Vec3d mass_centre(const Object& object, const Item& item, const ItemOptions& own, const Design& design) {
    const auto centre = own.centre_mm ? own.centre_mm : design.protection.centre_mm;
    return centre ? item.placement.rotation(*centre - origin_mm(object)) + item.placement.shift
                  : centre_of_mass(object, item.placement);
}

bool wants_protection(const Design& design) {
    return design.protection.drops() || design.protection.foam || any_zones(design);
}

Result<Protection> protection(std::span<const Object> objects, Packing& packing, const Design& design,
                              const Progress& progress) {
    Protection all = begun(objects, packing, design);
    auto zones = zone_reports(packing, progress);
    if (!zones) return tl::unexpected(zones.error());
    all.zones = std::move(*zones);
    const bool curve = all.foam && !all.foam->curve.empty();
    if (!curve) {
        for (ItemProtection& item : all.items) {
            item.rest.why_none = NoShock::no_foam_data;
            for (FaceShock& face : item.faces) face.why_none = obstacle(all, item, packing);
        }
    } else {
        const Curves curves(*all.foam);
        const auto contacts = contacts_by_axis(objects, packing, progress);
        if (!contacts) return tl::unexpected(contacts.error());
        for (const AxisContacts& each : *contacts) {
            add_face_shocks(each, packing, curves, all);
            add_pressing(each, curves, all);
            add_zone_pressures(each, curves, all);
        }
    }
    find_shocks(all, packing, packing.findings);
    find_lighter_fall(all, packing.findings);
    find_zones(all, packing, packing.findings);
    const bool whole =
        std::all_of(objects.begin(), objects.end(), [](const Object& each) { return each.whole(); });
    if (curve && !whole) {
        packing.findings.push_back({Severity::warning, say("shock_of_stand_in")});
        sort_by_severity(packing.findings);
    }
    if (curve && is_rigid(design)) {
        packing.findings.push_back({Severity::warning, say("foam_of_rigid", {{"foam", all.foam->name}})});
        sort_by_severity(packing.findings);
    }
    return all;
}

}  // namespace snug
