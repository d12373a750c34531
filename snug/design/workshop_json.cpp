#include "snug/design/workshop_json.h"

#include <array>
#include <map>
#include <optional>
#include <string>

namespace snug {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json sheets_json(const SheetOptions& sheets) {
    return {{"thickness_mm", or_null(sheets.thickness_mm)},
            {"stock_mm", Json::array({sheets.stock_mm.x, sheets.stock_mm.y})},
            {"margin_mm", sheets.margin_mm},
            {"spacing_mm", sheets.spacing_mm},
            {"kerf_mm", sheets.kerf_mm},
            {"dowel_mm", sheets.dowel_mm},
            {"dowels", sheets.dowels},
            {"dowel_edge_mm", sheets.dowel_edge_mm},
            {"svg", sheets.svg},
            {"dxf", sheets.dxf}};
}

Json print_json(const PrintOptions& print) {
    return {{"bed_mm", Json::array({print.bed_mm.x, print.bed_mm.y, print.bed_mm.z})},
            {"dowels", print.joint == PrintJoint::dowels},
            {"dowel_diameter_mm", print.dowel_diameter_mm},
            {"dowel_length_mm", print.dowel_length_mm},
            {"joint_clearance_mm", print.joint_clearance_mm}};
}

Json bricks_json(const BrickOptions& bricks) {
    Json stock = Json::object();
    for (const BrickStock& each : bricks.stock) stock[each.size] = each.pieces;
    return {{"unit", brick_unit_name(bricks.unit)},
            {"family", bricks.family},
            {"lower_color", bricks.lower_color},
            {"lid_color", bricks.lid_color},
            {"stock", stock},
            {"rim", brick_rim_name(bricks.rim)},
            {"capacity_n", bricks.capacity_n}};
}

Json mill_json(const MillOptions& mill) {
    return {{"cutter_mm", mill.cutter_mm},
            {"flute_mm", mill.flute_mm},
            {"step_down_mm", or_null(mill.step_down_mm)},
            {"stepover", mill.stepover},
            {"feed_mm_min", mill.feed_mm_min},
            {"plunge_mm_min", mill.plunge_mm_min},
            {"spindle_rpm", mill.spindle_rpm},
            {"safe_mm", mill.safe_mm},
            {"pin_mm", mill.pin_mm},
            {"origin", mill_origin_name(mill.origin)}};
}

Json mould_json(const MouldOptions& mould) {
    return {{"wall_mm", mould.wall_mm}, {"rim_mm", mould.rim_mm}, {"draft_deg", mould.draft_deg}};
}

void read_sheets(JsonReader json, SheetOptions& sheets, JsonReader& parent) {
    std::optional<std::array<double, 2>> stock;
    json.read("thickness_mm", sheets.thickness_mm)
        .read_list("stock_mm", stock, "two numbers in brackets (length, width)")
        .read("margin_mm", sheets.margin_mm)
        .read("spacing_mm", sheets.spacing_mm)
        .read("kerf_mm", sheets.kerf_mm)
        .read("dowel_mm", sheets.dowel_mm)
        .read("dowels", sheets.dowels)
        .read("dowel_edge_mm", sheets.dowel_edge_mm)
        .read("svg", sheets.svg)
        .read("dxf", sheets.dxf);
    if (stock)
        sheets.stock_mm = {(*stock)[0], (*stock)[1]};
    else if (json.has("stock_mm"))
        json.refuse("stock_mm", "two numbers in brackets (length, width)");
    parent.adopt(json);
}

void read_print(JsonReader json, PrintOptions& print, JsonReader& parent) {
    bool dowels = print.joint == PrintJoint::dowels;
    json.read("bed_mm", print.bed_mm)
        .read("dowels", dowels)
        .read("dowel_diameter_mm", print.dowel_diameter_mm)
        .read("dowel_length_mm", print.dowel_length_mm)
        .read("joint_clearance_mm", print.joint_clearance_mm);
    print.joint = dowels ? PrintJoint::dowels : PrintJoint::none;
    parent.adopt(json);
}

/// One of a few words.
template <class Value, class FromName>
void read_word(JsonReader& json, const char* field, Value& value, FromName from_name, const char* expected) {
    std::optional<std::string> word;
    json.read(field, word);
    if (!word) return;
    if (const auto known = from_name(*word))
        value = *known;
    else
        json.refuse(field, expected);
}

void read_bricks(JsonReader json, BrickOptions& bricks, JsonReader& parent) {
    read_word(json, "unit", bricks.unit, brick_unit_from_name, "auto, brick or plate");
    read_word(json, "rim", bricks.rim, brick_rim_from_name, "studs or tiles");
    std::optional<std::map<std::string, int>> stock;
    json.read("family", bricks.family)
        .read("lower_color", bricks.lower_color)
        .read("lid_color", bricks.lid_color)
        .read("stock", stock)
        .read("capacity_n", bricks.capacity_n);
    if (stock) {
        bricks.stock.clear();
        for (const auto& [size, pieces] : *stock) bricks.stock.push_back({size, pieces});
    }
    parent.adopt(json);
}

void read_mill(JsonReader json, MillOptions& mill, JsonReader& parent) {
    json.read("cutter_mm", mill.cutter_mm)
        .read("flute_mm", mill.flute_mm)
        .read("step_down_mm", mill.step_down_mm)
        .read("stepover", mill.stepover)
        .read("feed_mm_min", mill.feed_mm_min)
        .read("plunge_mm_min", mill.plunge_mm_min)
        .read("spindle_rpm", mill.spindle_rpm)
        .read("safe_mm", mill.safe_mm)
        .read("pin_mm", mill.pin_mm);
    read_word(json, "origin", mill.origin, mill_origin_from_name, "corner or centre");
    parent.adopt(json);
}

void read_mould(JsonReader json, MouldOptions& mould, JsonReader& parent) {
    json.read("wall_mm", mould.wall_mm).read("rim_mm", mould.rim_mm).read("draft_deg", mould.draft_deg);
    parent.adopt(json);
}

}  // namespace

Json workshop_json(const WorkshopOptions& workshop) {
    const std::string work(workshop_name(workshop.work));
    return {{"for", work.empty() ? Json(nullptr) : Json(work)},
            {"paper", workshop.paper},
            {"price_per_litre", or_null(workshop.price_per_litre)},
            {"currency", workshop.currency},
            {"mass_kg", or_null(workshop.mass_kg)},
            {"density_kg_m3", or_null(workshop.density_kg_m3)},
            {"sheets", sheets_json(workshop.sheets)},
            {"print", print_json(workshop.print)},
            {"bricks", bricks_json(workshop.bricks)},
            {"mill", mill_json(workshop.mill)},
            {"mould", mould_json(workshop.mould)}};
}

void read_workshop(JsonReader json, WorkshopOptions& workshop, JsonReader& parent) {
    std::optional<std::string> work;
    json.read("for", work)
        .read("paper", workshop.paper)
        .read("price_per_litre", workshop.price_per_litre)
        .read("currency", workshop.currency)
        .read("mass_kg", workshop.mass_kg)
        .read("density_kg_m3", workshop.density_kg_m3);
    if (work && !workshop_from_name(*work)) json.refuse("for", workshop_names() + ", or null");
    workshop.work = work ? workshop_from_name(*work).value_or(Workshop::none) : Workshop::none;
    read_sheets(json.object("sheets"), workshop.sheets, json);
    read_print(json.object("print"), workshop.print, json);
    read_bricks(json.object("bricks"), workshop.bricks, json);
    read_mill(json.object("mill"), workshop.mill, json);
    read_mould(json.object("mould"), workshop.mould, json);
    parent.adopt(json);
}

}  // namespace snug
