#include "snug/fabricate/kit/protection_json.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "snug/check/zone_room.h"
#include "snug/fabricate/kit/json_values.h"
#include "snug/fabricate/kit/shock_text.h"
#include "snug/words/words.h"

namespace snug {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// By words for programs, which are the same in every language.
OrderedJson left_out() {
    OrderedJson list = OrderedJson::array();
    for (const Message& what : not_computed()) list.push_back(text(what));
    return list;
}

OrderedJson material_json(const FoamMaterial& foam) {
    return {
        {"name", foam.name},
        {"status", name_of(foam.status)},
        {"source", foam.source},
        {"thickness_mm", foam.thickness_mm ? OrderedJson::array({foam.thickness_mm->x, foam.thickness_mm->y})
                                           : OrderedJson(nullptr)},
        {"impacts", foam.impacts ? OrderedJson(*foam.impacts) : OrderedJson(nullptr)}};
}

OrderedJson face_json(const FaceShock& face) {
    const bool told = face.travel_mm.has_value();
    OrderedJson json{
        {"face", side_name(face.face)},
        {"g", face.g_low ? OrderedJson::array({rounded(*face.g_low, 1e3), or_null(face.g_high, 1e3)})
                         : OrderedJson(nullptr)},
        {"g_model", or_null(face.g_model, 1e6)},
        {"sink_mm", or_null(face.travel_mm, 1e6)},
        {"strain", told ? OrderedJson(rounded(face.strain, 1e6)) : OrderedJson(nullptr)},
        {"peak_kpa", told ? OrderedJson(rounded(face.peak_kpa, 1e4)) : OrderedJson(nullptr)},
        {"peak_at_mm", told ? array(face.peak_at) : OrderedJson(nullptr)},
        {"area_cm2", told ? OrderedJson(rounded(face.area_cm2, 1e4)) : OrderedJson(nullptr)},
        {"tilt_mm", told ? OrderedJson(rounded(face.tilt_mm, 1e4)) : OrderedJson(nullptr)},
        {"bottoms", face.bottoms}};
    if (face.why_none != NoShock::none) json["why_none"] = name_of(face.why_none);
    if (face.more_foam_mm) json["more_foam_mm"] = *face.more_foam_mm;
    return json;
}

OrderedJson rest_json(const RestReport& rest) {
    if (rest.why_none != NoShock::none) return {{"why_none", name_of(rest.why_none)}};
    return {{"sink_mm", rounded(rest.sink_mm, 1e6)},
            {"strain", rounded(rest.strain, 1e6)},
            {"peak_kpa", rounded(rest.peak_kpa, 1e4)},
            {"area_cm2", rounded(rest.area_cm2, 1e4)}};
}

OrderedJson faces_json(const ItemProtection& item) {
    OrderedJson list = OrderedJson::array();
    for (const FaceShock& face : item.faces) list.push_back(face_json(face));
    return list;
}

OrderedJson item_json(const ItemProtection& item) {
    return {{"mass_kg", or_null(item.mass_kg, 1e6)},
            {"fragility_g", or_null(item.asked_g, 1e6)},
            {"centre_mm", array(item.centre)},
            {"centre", item.centre_given ? "given" : "assumed uniform"},
            {"faces", faces_json(item)},
            {"rest", rest_json(item.rest)},
            {"pressed_n", or_null(item.pressed_n, 1e4)}};
}

OrderedJson protected_items(const Protection& all) {
    OrderedJson list = OrderedJson::array();
    for (std::size_t i = 0; i < all.items.size(); ++i) {
        OrderedJson item = item_json(all.items[i]);
        list.push_back(OrderedJson{{"number", i + 1}});
        list.back().update(item);
    }
    return list;
}

/// A length by side; null where nothing stands in the way or nothing is known.
template <class T>
OrderedJson by_side(const std::array<T, 6>& values, double steps) {
    OrderedJson json = OrderedJson::object();
    for (std::size_t side = 0; side < 6; ++side) {
        const std::optional<double> value = values[side];
        json[std::string(side_name(static_cast<Side>(side)))] =
            value && std::isfinite(*value) ? OrderedJson(rounded(*value, steps)) : OrderedJson(nullptr);
    }
    return json;
}

OrderedJson zone_json(const ZoneReport& zone) {
    const Zone& asked = zone.asked;
    OrderedJson json{{"item", zone.item + 1},
                     {"zone", zone.number},
                     {"keep_off_mm", rounded(asked.keep_off_mm, 1e6)},
                     {"loose", asked.loose},
                     {"where_mm", array(zone.where)}};
    if (asked.keep_off_mm > 0) {
        const auto nearest = zone.nearest();
        json["cut_blocks"] = zone.cut_blocks;
        json["room_mm"] = by_side(zone.room_mm, 1e3);
        json["left_mm"] = by_side(zone.left_mm, 1e3);
        json["reached"] = nearest ? OrderedJson(*zone.left_mm[*nearest] < kZoneRoom) : OrderedJson(nullptr);
    }
    if (asked.press_kpa) {
        json["press_kpa"] = rounded(*asked.press_kpa, 1e6);
        json["rest_kpa"] = or_null(zone.rest_kpa, 1e4);
        json["peak_kpa"] = by_side(zone.press_kpa, 1e4);
    }
    return json;
}

std::optional<double> mass_of_all(const Protection& all) {
    double sum = 0;
    for (const ItemProtection& item : all.items) {
        if (!item.mass_kg) return {};
        sum += *item.mass_kg;
    }
    return sum;
}

}  // namespace

OrderedJson protection_json(const Protection& all) {
    OrderedJson json{
        {"drop_mm", or_null(all.drop_mm, 1e6)},
        {"rule", all.rule ? OrderedJson(name_of(*all.rule)) : OrderedJson(nullptr)},
        {"rule_verified", all.rule ? OrderedJson(is_verified(*all.rule)) : OrderedJson(nullptr)},
        {"fragility_source", all.fragility ? OrderedJson(source_of(*all.fragility)) : OrderedJson(nullptr)},
        {"mass_kg", or_null(mass_of_all(all), 1e6)},
        {"gross_kg", or_null(all.gross_kg, 1e6)},
        {"gross_of", all.gross_without_foam ? "items" : "items and foam"},
        {"foam", all.foam ? material_json(*all.foam) : OrderedJson(nullptr)}};
    if (all.items.size() == 1) {
        json.update(item_json(all.items.front()));
    } else {
        json["faces"] = OrderedJson::array();
        for (int side = 0; side < 6; ++side) {
            const std::size_t worst = all.worst_item(static_cast<Side>(side));
            json["faces"].push_back(face_json(all.items[worst].faces[static_cast<std::size_t>(side)]));
            json["faces"].back()["item"] = worst + 1;
        }
        json["rest"] = nullptr;
        json["items"] = protected_items(all);
    }
    json["zones"] = OrderedJson::array();
    for (const ZoneReport& zone : all.zones) json["zones"].push_back(zone_json(zone));
    json["not_computed"] = left_out();
    return json;
}

}  // namespace snug
