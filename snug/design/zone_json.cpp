#include "snug/design/zone_json.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "snug/design/json_reader.h"

namespace snug {
namespace {

bool read_balls(const nlohmann::json& json, std::vector<Zone::Ball>& balls) {
    if (!json.is_array()) return false;
    for (const nlohmann::json& each : json) {
        const auto is_number = [](const nlohmann::json& value) { return value.is_number(); };
        if (!each.is_array() || each.size() != 4 || !std::all_of(each.begin(), each.end(), is_number))
            return false;
        const auto v = each.get<std::array<double, 4>>();
        balls.push_back({{v[0], v[1], v[2]}, v[3]});
    }
    return true;
}

bool read_zone(const nlohmann::json& json, Zone& zone) {
    if (!json.is_object()) return false;
    nlohmann::json rest = json;
    if (rest.contains("balls")) {
        if (!read_balls(rest["balls"], zone.balls)) return false;
        rest.erase("balls");
    }
    JsonReader reader(rest, "");
    reader.read("part", zone.part)
        .read("keep_off_mm", zone.keep_off_mm)
        .read("press_kpa", zone.press_kpa)
        .read("loose", zone.loose);
    return !reader.problem();
}

}  // namespace

nlohmann::ordered_json zones_json(const Zones& zones) {
    auto json = nlohmann::ordered_json::array();
    for (const Zone& zone : zones) {
        nlohmann::ordered_json each = nlohmann::ordered_json::object();
        for (const Zone::Ball& ball : zone.balls)
            each["balls"].push_back({ball.centre.x, ball.centre.y, ball.centre.z, ball.radius_mm});
        if (zone.part != 0) each["part"] = zone.part;
        if (zone.keep_off_mm != 0) each["keep_off_mm"] = zone.keep_off_mm;
        if (zone.press_kpa) each["press_kpa"] = *zone.press_kpa;
        if (zone.loose) each["loose"] = true;
        json.push_back(std::move(each));
    }
    return json;
}

bool read_zones(const nlohmann::json& json, Zones& zones) {
    zones.clear();
    if (!json.is_array()) return false;
    for (const nlohmann::json& each : json) {
        Zone zone;
        if (!read_zone(each, zone)) return false;
        zones.push_back(std::move(zone));
    }
    return true;
}

}  // namespace snug
