#include "snug/fabricate/kit/report_json.h"

#include <cmath>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "snug/fabricate/kit/json_values.h"
#include "snug/fabricate/kit/piece_names.h"
#include "snug/fabricate/kit/protection_json.h"
#include "snug/space/fitted_space.h"
#include "snug/words/words.h"

namespace snug {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson volume(const std::optional<double>& mm3) {
    return mm3 ? OrderedJson(rounded(*mm3, 1e3)) : OrderedJson(nullptr);
}

OrderedJson half_gap_json(const HalfGap& half) {
    return {{"step_mm3", volume(half.step_mm3)},
            {"undercut_mm3", volume(half.undercut_mm3)},
            {"widest_mm", rounded(half.widest_mm, 1e4)},
            {"widest_error_mm", rounded(half.widest_error_mm, 1e4)},
            {"widest_at_mm", array(half.widest_at)}};
}

OrderedJson dropped_json(const std::vector<PartShare>& dropped) {
    OrderedJson list = OrderedJson::array();
    for (const PartShare& part : dropped)
        list.push_back({{"part", part.number},
                        {"triangles", part.triangles},
                        {"size_mm", array(part.bounds.size())},
                        {"surface_share", rounded(part.share)}});
    return list;
}

/// What is not known of an object is null.
OrderedJson object_json(const Object& object, const std::string& file) {
    const MeshMeasure& measure = object.measure;
    const bool whole = object.whole();
    const bool vertices = object.read.vertices > 0;
    OrderedJson json = {{"file", file},
                        {"vertices", vertices ? OrderedJson(object.read.vertices) : OrderedJson(nullptr)},
                        {"triangles", object.read.triangles},
                        {"size_mm", array(measure.bounds.size())},
                        {"watertight", whole ? OrderedJson(measure.watertight) : OrderedJson(nullptr)},
                        {"volume_mm3", volume(measure.volume)}};
    if (!object.clean.dropped.empty()) json["dropped"] = dropped_json(object.clean.dropped);
    if (object.clean.plane_cut) json["cut_off"] = true;
    if (object.is_cloud()) json["points"] = object.read.vertices;
    if (object.is_streamed()) json["streamed"] = true;
    return json;
}

/// Whole numbers without a point.
OrderedJson lines_json(double lines) {
    return lines >= 1 ? OrderedJson(static_cast<int>(lines)) : OrderedJson(lines);
}

OrderedJson gap_json(const GapFigures& gap) {
    return {{"cut_mm3", volume(gap.cut_mm3)},
            {"hull_mm3", volume(gap.hull_mm3)},
            {"solid_mm3", volume(gap.solid_mm3)},
            {"step_mm3", volume(gap.step_mm3)},
            {"undercut_mm3", volume(gap.undercut_mm3)},
            {"error_mm3", volume(gap.error_mm3)},
            {"lines_per_column", lines_json(gap.lines_per_column)},
            {"widest_mm", rounded(gap.widest_mm, 1e4)},
            {"widest_error_mm", rounded(gap.widest_error_mm, 1e4)},
            {"widest_at_mm", array(gap.widest_at)},
            {"lower", half_gap_json(gap.lower)},
            {"upper", half_gap_json(gap.upper)}};
}

OrderedJson findings_json(const std::vector<Finding>& findings, Language language) {
    OrderedJson list = OrderedJson::array();
    for (const Finding& finding : findings)
        list.push_back({{"severity", severity_name(finding.severity)},
                        {"code", finding.code()},
                        {"message", text(said_of_item(finding), language)},
                        {"where", finding.where ? array(*finding.where) : OrderedJson(nullptr)}});
    return list;
}

/// Of one layer a number.
OrderedJson parting_json(const std::vector<int>& levels) {
    return levels.size() == 1 ? OrderedJson(levels.front()) : OrderedJson(levels);
}

OrderedJson foam_json(const Packing& packing) {
    const FitReport& fit = packing.fit;
    const Foams& foams = *packing.foams;
    OrderedJson json{{"lower_blocks", fit.lower().blocks}, {"upper_blocks", fit.upper().blocks},
                     {"cut_blocks", fit.cut_blocks},       {"volume_mm3", rounded(fit.foam_mm3, 1e3)},
                     {"fill_ratio", fit.fill_ratio},       {"parting_level", parting_json(foams.parting)},
                     {"lower_pieces", fit.lower().parts},  {"upper_pieces", fit.upper().parts},
                     {"rib_blocks", packing.rib_blocks}};
    for (const Piece piece : foams.all()) {
        if (!piece.middle()) continue;
        const PieceFigures& figures = fit.pieces[static_cast<std::size_t>(piece.index)];
        json["middle"].push_back({{"blocks", figures.blocks}, {"pieces", figures.parts}});
    }
    return json;
}

/// One number where all six are equal.
OrderedJson clearance_json(const Clearance& clearance) {
    const auto& [a, b] = clearance;
    if (clearance.is_one()) return rounded(a.x);
    OrderedJson list = array(a);
    for (const OrderedJson& each : array(b)) list.push_back(each);
    return list;
}

/// Areas on either side and, with a mass, what it presses with on the lower.
OrderedJson bearing_areas(const BearingReport& bearing, std::optional<double> kg) {
    const auto areas = [](const auto& mm2) {
        OrderedJson list = OrderedJson::array();
        for (const double area : mm2) list.push_back(rounded(area, 1e3));
        return list;
    };
    OrderedJson pressure = nullptr;
    if (kg) {
        pressure = OrderedJson::array();
        for (const double area : bearing.lower_mm2) {
            const auto kpa = static_pressure_kpa(*kg, area);
            pressure.push_back(kpa ? OrderedJson(rounded(*kpa)) : OrderedJson(nullptr));
        }
    }
    return {{"lower_mm2", areas(bearing.lower_mm2)},
            {"upper_mm2", areas(bearing.upper_mm2)},
            {"static_kpa", pressure}};
}

OrderedJson bearing_json(const BearingReport& bearing, const Design& design, bool dropped) {
    OrderedJson json{{"sinking_mm", kSinking}};
    json.update(bearing_areas(bearing, mass_kg(design)));
    json["creep_kpa"] = design.fit.creep_kpa ? OrderedJson(*design.fit.creep_kpa) : OrderedJson(nullptr);
    json["drops"] = dropped ? "see protection" : "not checked";
    return json;
}

/// Each item as it finally lies.
OrderedJson items_json(const Packing& packing, const Project& project, const MeasuredFit& fit) {
    OrderedJson list = OrderedJson::array();
    const Vec3d walls = shift_between_walls(project.design.space, packing.fitted_case.has_value());
    for (std::size_t i = 0; i < packing.items.size(); ++i) {
        const Item& item = packing.items[i];
        const Box3d& box = item.placement.bounds;
        list.push_back(
            {{"name", item_name(project, project.design.items[i])},
             {"file", project.objects[item.object].file.name},
             {"number", i + 1},
             {"layer", item.layer},
             {"placement",
              {{"rotation_deg", array(item.rotation_deg)},
               {"offset_mm", array(item.offset_mm + walls + Vec3d{item.rise_mm - item.settled_mm, 0, 0})}}},
             {"box_mm", OrderedJson::array({array(box.min), array(box.max)})},
             {"clearance_mm", clearance_json(item.cut.clearance_mm)},
             {"mass_kg", item.mass_kg ? OrderedJson(rounded(*item.mass_kg)) : OrderedJson(nullptr)}});
        if (packing.foams && packing.foams->open() && item.layer == packing.foams->layers())
            list.back()["sunk_mm"] =
                rounded(packing.space.face(0, packing.foams->parting.back()) - box.min.x);
        if (item.settled_mm > 0) list.back()["settled_mm"] = rounded(item.settled_mm);
        if (item.tip_deg) list.back()["tips_at_deg"] = std::floor(*item.tip_deg);
        if (packing.items.size() > 1 && !fit.item_bearings.empty())
            list.back()["bearing"] = bearing_areas(fit.item_bearings[i], item.mass_kg);
        if (!item.group.empty()) list.back()["group"] = item.group;
    }
    return list;
}

/// Blocks that a hand took out of the foams and put back, and edits that do not apply.
OrderedJson edits_json(const std::vector<EditOutcome>& edits) {
    long long taken = 0, put_back = 0, unapplied = 0;
    for (const EditOutcome& edit : edits) {
        (edit.blocks > 0 ? taken : put_back) += std::abs(edit.blocks);
        unapplied += edit.why_not.has_value();
    }
    return {{"taken_blocks", taken}, {"put_back_blocks", put_back}, {"unapplied", unapplied}};
}

OrderedJson notches_json(const Packing& packing) {
    OrderedJson list = OrderedJson::array();
    for (const Notch& notch : packing.notches) {
        list.push_back({{"side", side_name(notch.side)},
                        {"at_mm", rounded(notch.at_mm)},
                        {"size_mm", array(notch.size_mm)}});
        if (packing.items.size() > 1) list.back()["item"] = notch.item + 1;
    }
    return list;
}

OrderedJson lift_json(const Packing& packing) {
    OrderedJson list = OrderedJson::array();
    for (const LiftSlot& slot : packing.lift.slots)
        list.push_back({{"piece", foam_stem(slot.piece)},
                        {"side", side_name(slot.side)},
                        {"at_mm", rounded(slot.at_mm)},
                        {"size_mm", array(slot.size_mm)}});
    return list;
}

/// Places in design coordinates.
OrderedJson pads_json(const FillPads& pads) {
    OrderedJson list = OrderedJson::array();
    for (std::size_t i = 0; i < pads.pads.size(); ++i) {
        const FillPad& pad = pads.pads[i];
        list.push_back({{"number", i + 1},
                        {"item", pad.item + 1},
                        {"piece", foam_stem(pad.piece)},
                        {"side", pad.above ? "above" : "below"},
                        {"thickness_mm", rounded(pad.thickness_mm)},
                        {"sheets", pad.sheets},
                        {"columns", OrderedJson::array({OrderedJson::array({pad.first_j, pad.first_k}),
                                                        OrderedJson::array({pad.end_j, pad.end_k})})},
                        {"box_mm", OrderedJson::array({array(pad.box.min), array(pad.box.max)})}});
    }
    return list;
}

/// Sizes as people name a case: length, width, height.
OrderedJson length_first(Vec3d size) {
    return array(Vec3d{size.z, size.y, size.x});
}

/// What a carrier bills at least, in whole kg, reckoned from the inside.
OrderedJson volumetric_kg(const CaseOptions& options) {
    if (!options.divisor) return nullptr;
    const Vec3d inside = *options.inside_mm;
    return std::ceil(inside.x * inside.y * inside.z * 1e-3 / *options.divisor);
}

OrderedJson case_json(const CaseSpace& fitted, int parting_level, const FitReport& fit) {
    const CaseOptions& options = fitted.options;
    const double foam_begin = options.play_mm + (fitted.rest_under ? fitted.rest_mm.x : 0);
    OrderedJson list = OrderedJson::array();
    for (const Filler& filler : fillers(fitted, parting_level, fit.open))
        list.push_back({{"side", side_name(filler.side)},
                        {"half", filler.lid ? "lid" : "lower"},
                        {"size_mm", length_first(filler.size_mm)}});
    return {{"name", options.name},
            {"inside_mm", length_first(*options.inside_mm)},
            {"play_mm", rounded(options.play_mm)},
            {"lid_mm", options.lid_mm ? OrderedJson(rounded(*options.lid_mm)) : OrderedJson(nullptr)},
            {"parting_mm", rounded(foam_begin + parting_level * fitted.space.block_mm.x)},
            {"lid_off_mm", fitted.lid_level ? OrderedJson(rounded(fitted.lid_off_mm)) : OrderedJson(nullptr)},
            {"rest_mm", length_first(fitted.rest_mm)},
            {"fillers", list},
            {"volumetric_kg", volumetric_kg(options)},
            {"shortened_blocks", fit.shortened_blocks}};
}

OrderedJson search_json(const SearchReport& search) {
    return {{"method", search.method},
            {"evaluations", search.evaluations},
            {"start_cut_blocks",
             search.start_cut_blocks ? OrderedJson(*search.start_cut_blocks) : OrderedJson(nullptr)},
            {"cut_blocks", search.cut_blocks},
            {"seed", search.seed},
            {"cancelled", search.cancelled}};
}

OrderedJson arrangement_json(const Arrangement& arrangement) {
    return {{"seed", arrangement.seed},
            {"work", arrangement.work},
            {"volume_mm3", volume(arrangement.volume_mm3)},
            {"lower_bound_mm3", volume(arrangement.lower_bound_mm3)},
            {"cancelled", arrangement.cancelled}};
}

OrderedJson workshop_json(const WorkshopPack& pack, Language language) {
    const PackMaterial& material = pack.material;
    OrderedJson figures = OrderedJson::array(), files = OrderedJson::array();
    for (const PackFigure& figure : pack.figures)
        figures.push_back({{"label", text(figure.label, language)}, {"value", text(figure.value, language)}});
    for (const PackFile& file : pack.files) files.push_back(file.name);
    for (const PackContainer& container : pack.containers) files.push_back(container.name);
    for (const DrawingDocument& document : pack.documents) files.push_back(document.name + ".pdf");
    return {{"pieces", material.pieces ? OrderedJson(*material.pieces) : OrderedJson(nullptr)},
            {"copies", material.copies},
            {"litres", or_null(material.litres, 1e6)},
            {"foam_kg", or_null(material.foam_kg, 1e6)},
            {"cost", or_null(material.cost, 1e4)},
            {"figures", figures},
            {"files", files}};
}

}  // namespace

std::string report_json(std::span<const Object> objects, const Project& project, const Made& made) {
    const Packing& packing = made.packing;
    const bool one = packing.items.size() == 1;
    OrderedJson json;
    json["object"] = one ? object_json(objects[packing.items.front().object],
                                       project.objects[packing.items.front().object].file.name)
                         : OrderedJson(nullptr);
    json["placement"] = one ? OrderedJson{{"rotation_deg", array(packing.items.front().rotation_deg)},
                                          {"offset_mm", array(packing.items.front().offset_mm)}}
                            : OrderedJson(nullptr);
    json["items"] = items_json(packing, project, made.fit);
    json["design_space"] = {{"blocks", array(packing.space.blocks)},
                            {"block_mm", array(packing.space.block_mm)}};
    json["foam"] = packing.foams ? foam_json(packing) : OrderedJson(nullptr);
    json["gap"] = made.fit.gap ? gap_json(*made.fit.gap) : OrderedJson(nullptr);
    json["bearing"] = made.fit.bearing ? bearing_json(*made.fit.bearing, project.design,
                                                      made.packing.protection.has_value())
                                       : OrderedJson(nullptr);
    if (made.packing.protection) json["protection"] = protection_json(*made.packing.protection);
    json["wall_mm"] = nullptr;
    if (packing.foams) {
        json["wall_mm"] = OrderedJson::array();
        for (const double wall : packing.fit.wall_mm) json["wall_mm"].push_back(rounded(wall));
    }
    if (!packing.lift.slots.empty()) json["lift"] = lift_json(packing);
    if (!packing.pads.pads.empty()) json["pads"] = pads_json(packing.pads);
    if (!packing.notches.empty()) json["notches"] = notches_json(packing);
    if (!packing.edits.empty()) json["edits"] = edits_json(packing.edits);
    if (packing.fitted_case) {
        const int level = packing.foams ? packing.foams->parting.back() : 0;
        json["case"] = case_json(*packing.fitted_case, level, packing.fit);
    }
    if (made.search) json["search"] = search_json(*made.search);
    if (made.arrangement) json["arrangement"] = arrangement_json(*made.arrangement);
    json["findings"] = findings_json(packing.findings, made.language);
    if (made.pack) json["workshop"] = workshop_json(*made.pack, made.language);
    const Timing& timing = packing.timing;
    json["timing_ms"] = {
        {"read", rounded(timing.read, 1e3)},           {"depth_map", rounded(timing.depth_map, 1e3)},
        {"block_map", rounded(timing.block_map, 1e3)}, {"foam_pair", rounded(timing.foam_pair, 1e3)},
        {"solids", rounded(timing.solids, 1e3)},       {"write", rounded(timing.write, 1e3)}};
    if (made.arrangement) json["timing_ms"]["arrangement"] = rounded(made.arrangement->ms, 1e3);
    return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace snug
