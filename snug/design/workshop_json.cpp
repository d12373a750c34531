#include "snug/design/workshop_json.h"

#include <array>
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
            {"print", print_json(workshop.print)}};
}

void read_workshop(JsonReader json, WorkshopOptions& workshop, JsonReader& parent) {
    std::optional<std::string> work;
    json.read("for", work)
        .read("paper", workshop.paper)
        .read("price_per_litre", workshop.price_per_litre)
        .read("currency", workshop.currency)
        .read("mass_kg", workshop.mass_kg)
        .read("density_kg_m3", workshop.density_kg_m3);
    if (work && !workshop_from_name(*work)) json.refuse("for", "sponge, sheets, print or null");
    workshop.work = work ? workshop_from_name(*work).value_or(Workshop::none) : Workshop::none;
    read_sheets(json.object("sheets"), workshop.sheets, json);
    read_print(json.object("print"), workshop.print, json);
    parent.adopt(json);
}

}  // namespace snug
