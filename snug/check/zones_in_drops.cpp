#include "snug/check/zones_in_drops.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/check/zone_pressure.h"
#include "snug/check/zone_room.h"
#include "snug/words/sides.h"

namespace snug {
namespace {

constexpr double kLeastSpread = 1.2;  // the range of a pressure is never narrower

ZoneReport begun_zone(const Packing& packing, std::size_t item, std::size_t zone) {
    const ItemZone& each = packing.items[item].zones[zone];
    ZoneReport report;
    report.item = item;
    report.number = zone + 1;
    report.asked = each.asked;
    report.where = each.bounds.centre();
    for (const ZoneCut& cut : packing.zone_cuts)
        if (cut.item == item && cut.zone == zone) report.cut_blocks = cut.blocks;
    return report;
}

void take_most(std::optional<double>& most, double value) {
    most = std::max(most.value_or(0), value);
}

std::string name_of(const Packing& packing, std::size_t item) {
    return packing.items.size() > 1 ? packing.items[item].name : std::string();
}

/// Whatever the blocks, foam that keeps so far off lets the item travel as far as it does.
double enough_mm(const ItemProtection& item) {
    double farthest = 0;
    for (const FaceShock& face : item.faces) farthest = std::max(farthest, face.travel_most_mm.value_or(0));
    return std::ceil(farthest + kZoneRoom);
}

/// Where foam or case is nearer after a drop than kZoneRoom.
void find_reached(const ZoneReport& zone, const Protection& all, const Packing& packing,
                  std::vector<Finding>& findings) {
    const auto nearest = zone.nearest();
    if (!nearest || *zone.left_mm[*nearest] >= kZoneRoom) return;
    const ItemProtection& item = all.items[zone.item];
    findings.push_back({Severity::danger,
                        say("zone_reached", {{"zone", zone.number},
                                             {"cm", number(*all.drop_mm / 10, 0)},
                                             {"fallen", fallen_on(*nearest)},
                                             {"travel", number(*item.faces[*nearest].travel_most_mm, 0)},
                                             {"room", number(zone.room_mm[*nearest], 0)},
                                             {"least", number(kZoneRoom, 0)},
                                             {"mm", number(enough_mm(item), 0)}}),
                        zone.where, name_of(packing, zone.item)});
}

void find_pressed(const ZoneReport& zone, const Packing& packing, std::vector<Finding>& findings) {
    const auto most = zone.most_kpa();
    if (!zone.asked.press_kpa || !most || *most * kLeastSpread <= *zone.asked.press_kpa) return;
    findings.push_back({Severity::danger,
                        say("zone_pressed", {{"zone", zone.number},
                                             {"kpa", number(*most * kLeastSpread, 1)},
                                             {"asked", number(*zone.asked.press_kpa, 1)}}),
                        zone.where, name_of(packing, zone.item)});
}

}  // namespace

std::optional<Side> ZoneReport::nearest() const {
    std::optional<Side> found;
    for (std::size_t side = 0; side < left_mm.size(); ++side)
        if (left_mm[side] && (!found || *left_mm[side] < *left_mm[*found])) found = static_cast<Side>(side);
    return found;
}

std::optional<double> ZoneReport::most_kpa() const {
    std::optional<double> most = rest_kpa;
    for (const auto& kpa : press_kpa)
        if (kpa) take_most(most, *kpa);
    return most;
}

Result<std::vector<ZoneReport>> zone_reports(const Packing& packing, const Progress& progress) {
    std::vector<ZoneReport> reports;
    for (std::size_t i = 0; i < packing.items.size(); ++i) {
        const Item& item = packing.items[i];
        for (std::size_t zone = 0; zone < item.zones.size(); ++zone) {
            reports.push_back(begun_zone(packing, i, zone));
            if (item.zones[zone].asked.keep_off_mm <= 0) continue;
            const auto room = zone_room_mm(item.zones[zone], item, packing, progress);
            if (!room) return tl::unexpected(room.error());
            reports.back().room_mm = *room;
        }
    }
    return reports;
}

void add_zone_pressures(const AxisContacts& contacts, const Curves& curves, Protection& all) {
    for (const ZonePads& pads : contacts.zones)
        for (ZoneReport& zone : all.zones) {
            if (zone.item != pads.item || zone.number != pads.zone + 1) continue;
            const auto side = static_cast<std::size_t>(2 * contacts.axis + (pads.high ? 1 : 0));
            const ItemProtection& item = all.items[pads.item];
            const bool rests_on_it = side == kFloor && item.rest.why_none == NoShock::none;
            const double rest_mm = rests_on_it ? item.rest.sink_mm : 0;
            take_most(zone.rest_kpa, most_mean_kpa(pads.columns, rest_mm, curves.given));
            if (const auto travel = item.faces[side].travel_mm)
                zone.press_kpa[side] = most_mean_kpa(pads.columns, *travel, curves.given);
        }
}

void find_zones(Protection& all, const Packing& packing, std::vector<Finding>& findings) {
    bool free = false;
    for (ZoneReport& zone : all.zones) {
        if (zone.asked.keep_off_mm > 0) {
            free = true;
            const ItemProtection& item = all.items[zone.item];
            for (std::size_t side = 0; side < zone.left_mm.size(); ++side) {
                if (const auto travel = item.faces[side].travel_most_mm)
                    zone.left_mm[side] = zone.room_mm[side] - *travel;
                if (item.faces[side].bottoms) zone.unknown.push_back(static_cast<Side>(side));
            }
            find_reached(zone, all, packing, findings);
        }
        find_pressed(zone, packing, findings);
    }
    if (free) findings.push_back({Severity::note, say("zone_free")});
    sort_by_severity(findings);
}

}  // namespace snug
