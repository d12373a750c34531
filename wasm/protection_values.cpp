#include "wasm/protection_values.h"

#include <string>

#include <nlohmann/json.hpp>

#include "snug/check/drop_sentence.h"
#include "snug/design/carrier.h"
#include "snug/design/drop_rules.h"
#include "snug/design/known_foams.h"
#include "snug/design/option_json.h"
#include "snug/fabricate/kit/shock_text.h"
#include "snug/words/sides.h"

namespace snug::wasm {
namespace {

val or_null(const std::optional<double>& value) {
    return value ? val(*value) : val::null();
}

template <class List>
val messages_val(const List& messages) {
    val list = val::array();
    for (const Message& message : messages) list.call<void>("push", to_val(message));
    return list;
}

val title_val(const FoamMaterial& foam) {
    val both = val::array();
    for (const Language language : {Language::english, Language::japanese})
        both.call<void>("push", title_of(foam, language));
    return both;
}

val foam_val(FoamMaterial foam) {
    OptionList list;
    visit_options(list, foam);
    val result = val::object();
    result.set("design", json_of(list).dump());
    result.set("title", title_val(foam));
    result.set("curve", foam.curve.empty() ? val::null() : to_val(curve_text(foam)));
    result.set("status", to_val(status_text(foam.status)));
    result.set("source", foam.source);
    return result;
}

val face_val(const FaceShock& face, const ItemProtection& item, const Protection& all) {
    val force = val::array();
    for (const Vec2d point : face.force) {
        force.call<void>("push", point.x);
        force.call<void>("push", point.y);
    }
    val result = val::object();
    result.set("side", static_cast<int>(face.face));
    result.set("fallen", to_val(fallen_on(face.face)));
    result.set("verdict", std::string(name_of(verdict_on(face, item))));
    result.set("sentence", to_val(drop_sentence(face, item, all)));
    const auto advice = drop_advice(face, item, all);
    result.set("advice", advice ? to_val(*advice) : val::null());
    result.set("peak_at", to_val(face.peak_at));
    result.set("low_g", or_null(face.g_low));
    result.set("high_g", or_null(face.g_high));
    result.set("travel_mm", or_null(face.travel_mm));
    result.set("strain", face.strain);
    result.set("peak_kpa", face.peak_kpa);
    result.set("area_cm2", face.area_cm2);
    result.set("force", force);
    return result;
}

val rest_val(const RestReport& rest) {
    if (rest.why_none != NoShock::none) return val::null();
    val result = val::object();
    result.set("sink_mm", rest.sink_mm);
    result.set("peak_kpa", rest.peak_kpa);
    result.set("area_cm2", rest.area_cm2);
    return result;
}

val item_val(const ItemProtection& item, const Protection& all) {
    val faces = val::array();
    for (const FaceShock& face : item.faces) faces.call<void>("push", face_val(face, item, all));
    val result = val::object();
    result.set("mass_kg", or_null(item.mass_kg));
    result.set("asked_g", or_null(item.asked_g));
    result.set("centre", to_val(item.centre));
    result.set("centre_given", item.centre_given);
    result.set("faces", faces);
    result.set("rest", rest_val(item.rest));
    return result;
}

}  // namespace

val protection_choices() {
    val foams = val::array(), rules = val::array(), classes = val::array();
    for (const FoamMaterial& foam : built_in_foams()) foams.call<void>("push", foam_val(foam));
    for (std::size_t i = 0; i < names_of<DropRule>().size(); ++i) {
        const auto rule = static_cast<DropRule>(i);
        val one = val::object();
        one.set("name", std::string(name_of(rule)));
        one.set("title", std::string(title_of(rule)));
        one.set("verified", is_verified(rule));
        rules.call<void>("push", one);
    }
    for (std::size_t i = 0; i < names_of<FragilityClass>().size(); ++i) {
        const auto each = static_cast<FragilityClass>(i);
        val one = val::object();
        one.set("name", std::string(name_of(each)));
        one.set("g", fragility_g(each));
        one.set("source", std::string(source_of(each)));
        classes.call<void>("push", one);
    }
    val result = val::object();
    result.set("foams", foams);
    result.set("rules", rules);
    result.set("classes", classes);
    result.set("tray", to_val(*no_shock_text(NoShock::open)));
    val walls = val::object();
    for (std::size_t i = 0; i < names_of<Carrier>().size(); ++i) {
        const auto carrier = static_cast<Carrier>(i);
        walls.set(std::string(name_of(carrier)), usual_wall_mm(carrier));
    }
    result.set("walls_mm", walls);
    return result;
}

val foams_val(const std::string& text) {
    const auto foams = parse_foams(text);
    if (!foams) return to_val(foams.error());
    val list = val::array();
    for (const FoamMaterial& foam : *foams) list.call<void>("push", foam_val(foam));
    val result = val::object();
    result.set("foams", list);
    return result;
}

val to_val(const Protection& all, const Packing& packing, const std::vector<Finding>& fitting) {
    val items = val::array(), worst = val::array();
    for (const ItemProtection& item : all.items) items.call<void>("push", item_val(item, all));
    for (const Side side : all.worst_first()) {
        val one = val::object();
        one.set("side", static_cast<int>(side));
        one.set("item", static_cast<double>(all.worst_item(side)));
        worst.call<void>("push", one);
    }
    val result = val::object();
    result.set("what", all.drop_mm && all.foam ? to_val(drop_text(all)) : val::null());
    result.set("drop_mm", or_null(all.drop_mm));
    result.set("gross_kg", or_null(all.gross_kg));
    result.set("items", items);
    result.set("worst", worst);
    result.set("claim", to_val(say("packing.drops_claim")));
    result.set("notComputed", messages_val(not_computed()));
    result.set("findings", to_val(packing.findings, packing.items));
    result.set("fitting", to_val(fitting, packing.items));
    return result;
}

val contacts_val(const ContactMap& map, const Protection& all, std::optional<Side> side) {
    val items = val::array();
    for (std::size_t i = 0; i < map.items.size(); ++i) {
        std::vector<float> numbers;
        for (const PressedColumn& column : map.items[i].columns)
            for (const double each :
                 {double{1} * column.row, double{1} * column.column, column.high ? 1.0 : 0.0, column.from_mm,
                  column.to_mm, column.strain, column.kpa})
                numbers.push_back(static_cast<float>(each));
        const auto why = no_contact_text(all.items[i], all, side);
        val one = val::object();
        one.set("why", why ? to_val(*why) : val::null());
        one.set("columns", typed_array(numbers.data(), numbers.size()));
        items.call<void>("push", one);
    }
    val cell = val::array();
    cell.call<void>("push", map.cell_mm.x);
    cell.call<void>("push", map.cell_mm.y);
    val result = val::object();
    result.set("axis", map.axis);
    result.set("rows", map.rows);
    result.set("columns", map.columns);
    result.set("cell_mm", cell);
    result.set("items", items);
    return result;
}

}  // namespace snug::wasm
