#include "snug/fabricate/processes.h"

#include <array>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "snug/base/one_line.h"
#include "snug/base/text.h"
#include "snug/design/presets.h"
#include "snug/drawing/svg.h"
#include "snug/fabricate/bricks/bricks.h"
#include "snug/fabricate/kit/item_labels.h"
#include "snug/fabricate/kit/packing_sheet.h"
#include "snug/fabricate/kit/start_here.h"
#include "snug/fabricate/mill/mill.h"
#include "snug/fabricate/mould/mould.h"
#include "snug/fabricate/print/print.h"
#include "snug/fabricate/sheets/sheets_pack.h"
#include "snug/fabricate/sponge/sponge.h"
#include "snug/space/placed_mesh.h"

namespace snug {
namespace {

constexpr std::size_t kLongestTitle = 60;  // characters

/// "vase.stl" is the vase to those who pack it.
std::string without_ending(const std::string& file_name) {
    const std::size_t dot = file_name.rfind('.');
    return dot == std::string::npos || dot == 0 ? file_name : file_name.substr(0, dot);
}

/// In a line of a page.
std::string short_title(const std::string& name) {
    const std::vector<std::string> lines = wrapped(one_line(name), kLongestTitle, 1);
    return lines.empty() ? "object" : lines.front();
}

/// As names_of_items() has them, without the endings of files.
std::string title_of(Project project) {
    for (ProjectObject& object : project.objects) object.file.name = without_ending(object.file.name);
    return short_title(names_of_items(project));
}

/// What people call an item.
std::string short_name(const Project& project, std::size_t item) {
    return short_title(without_ending(item_name(project, project.design.items[item])));
}

/// Whether a finding about labels matters to a way of working: maps are printed, sheets, prints and milled
/// foam engraved, bricks and cast foam bear none.
bool concerns(const Finding& finding, Workshop work) {
    if (work == Workshop::bricks || work == Workshop::mould) return false;
    return work != Workshop::sponge || finding.code() == "no_label";
}

/// Of a tray, whose surface everybody sees.
ItemLabels labels_of(const Packing& packing, const Project& project) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < packing.items.size(); ++i) names.push_back(short_name(project, i));
    const WorkshopOptions& options = project.design.workshop;
    const double slit = options.work == Workshop::sheets ? options.sheets.liner_slit_mm : 0;
    return item_labels(packing.items, names, packing.layers, *packing.foams, packing.space, slit);
}

std::vector<PackedItem> packed_items(std::span<const Object> objects, const Packing& packing,
                                     const Project& project) {
    std::vector<PackedItem> items;
    for (std::size_t i = 0; i < packing.items.size(); ++i) {
        const Item& item = packing.items[i];
        items.push_back({short_name(project, i), objects[item.object].measure.bounds.size(),
                         mass_kg(project.design.items[i], project.design), objects[item.object].mesh,
                         item.placement, item.layer});
        for (const ItemZone& zone : item.zones) items.back().zones.push_back(zone.bounds);
    }
    return items;
}

std::optional<double> density(const Design& design) {
    if (design.workshop.density_kg_m3) return design.workshop.density_kg_m3;
    const auto preset = find_preset(built_in_presets(), design.space.preset);
    return preset ? preset->density_kg_m3 : std::nullopt;
}

/// What is printed is rigid unless the preset is of something else.
PrintOptions print_options(const Design& design) {
    PrintOptions options = design.workshop.print;
    if (const auto preset = find_preset(built_in_presets(), design.space.preset))
        options.rigid = preset->rigid;
    return options;
}

/// What the cutter must not leave foam in; a cloud's or a stream's object is known by its blocks alone.
std::optional<MilledObject> milled_object(std::span<const Object> objects, const Packing& packing) {
    MilledObject milled{{}, packing.fitted_case ? &*packing.fitted_case : nullptr};
    for (const Item& item : packing.items) {
        if (!objects[item.object].whole()) return {};
        milled.surfaces.push_back({objects[item.object].mesh, item.placement, item.cut, item.layer});
    }
    return milled;
}

/// What a way of working may ask for.
struct Work {
    const FoamDesign& foams;
    std::span<const Object> objects;
    const Packing& packing;
    const Design& design;
    const WorkshopTools& tools;
    const WorkshopOptions& options = design.workshop;
};

/// A way of working and what makes its pack: a new one is a row here, beside its folder and its options.
struct Process {
    Workshop work;
    Result<WorkshopPack> (*pack)(const Work&);
};
constexpr std::array kProcesses{
    Process{Workshop::sponge, [](const Work& w) { return sponge_pack(w.foams, w.options); }},
    Process{Workshop::sheets,
            [](const Work& w) { return sheets_pack(w.foams, w.options.sheets, paper_mm(w.options.paper)); }},
    Process{Workshop::print, [](const Work& w) { return print_pack(w.foams, print_options(w.design)); }},
    Process{Workshop::bricks,
            [](const Work& w) { return brick_pack(w.foams, w.options, w.tools.solve_lp, w.tools.progress); }},
    Process{Workshop::mill,
            [](const Work& w) {
                return mill_pack(w.foams, milled_object(w.objects, w.packing), w.options.mill,
                                 paper_mm(w.options.paper));
            }},
    Process{Workshop::mould, [](const Work& w) { return mould_pack(w.foams, w.options); }},
};

Result<WorkshopPack> pack_of(const Work& work) {
    for (const Process& process : kProcesses)
        if (process.work == work.options.work) return process.pack(work);
    const std::string ways = any_of(names_of<Workshop>().subspan(1));
    return fail(ErrorKind::usage, say("workshop.none", {{"names", ways}}));
}

void fill_material(const Packing& packing, const Design& design, WorkshopPack& pack) {
    const double foam_litres = packing.fit.foam_mm3 * 1e-6;
    PackMaterial& material = pack.material;
    if (!material.litres) material.litres = foam_litres;
    if (const auto kg_m3 = density(design)) material.foam_kg = foam_litres * 1e-3 * *kg_m3;
    if (design.workshop.price_per_litre) material.cost = *material.litres * *design.workshop.price_per_litre;
}

std::string with_currency(double price, const std::string& currency) {
    return number(price, 2) + (currency.empty() ? "" : " " + currency);
}

Message cost_text(const PackMaterial& material, const WorkshopOptions& options) {
    if (!material.cost) return say("figure.no_price");
    const auto money = [&](double price) { return with_currency(price, options.currency); };
    const std::string price = money(*options.price_per_litre);
    if (material.copies == 1)
        return say("figure.cost_of", {{"cost", money(*material.cost)}, {"price", price}});
    return say("figure.cost_of/copies", {{"cost", money(*material.cost)},
                                         {"price", price},
                                         {"copies", material.copies},
                                         {"each", money(*material.cost / material.copies)}});
}

void tell_material(const Design& design, WorkshopPack& pack) {
    const PackMaterial& material = pack.material;
    const WorkshopOptions& options = design.workshop;
    pack.figures.push_back({say("figure.material"), litres_text(*material.litres)});
    pack.figures.push_back(
        {say("figure.weight"), material.foam_kg
                                   ? as_it_is(number(*material.foam_kg * material.copies, 3) + " kg")
                                   : say("figure.no_density")});
    pack.figures.push_back({say("figure.cost"), cost_text(material, options)});
}

}  // namespace

Result<WorkshopPack> workshop_pack(std::span<const Object> objects, const Packing& packing,
                                   const Project& project, const WorkshopTools& tools) {
    if (!packing.foams) return fail(ErrorKind::does_not_fit, say("workshop.no_foams"));
    const ItemLabels labels = packing.foams->open() ? labels_of(packing, project) : ItemLabels{};
    const FoamDesign foams{packing.space,     packing.layers, *packing.foams, packing.available,
                           title_of(project), tools.language, labels.labels};
    auto pack = pack_of({foams, objects, packing, project.design, tools});
    if (!pack) return pack;
    for (const Finding& finding : labels.findings)
        if (concerns(finding, project.design.workshop.work)) pack->findings.push_back(finding);
    fill_material(packing, project.design, *pack);
    tell_material(project.design, *pack);

    std::vector<Finding> findings = packing.findings;
    findings.insert(findings.end(), pack->findings.begin(), pack->findings.end());
    sort_by_severity(findings);
    const std::deque<PlacedMesh> meshes = placed_layers(objects, packing.items, packing.foams->layers());
    std::vector<PackedLayer> layers;
    for (const PlacedMesh& mesh : meshes) {
        const int layer = static_cast<int>(layers.size()) + 1;
        layers.push_back({layer, mesh.mesh(), mesh.placement(), numbered_places(packing.items, layer)});
    }
    pack->documents.push_back(
        packing_sheet({foams, packing.fit, findings, std::move(layers),
                       packed_items(objects, packing, project), pack->material, project.design.workshop,
                       packing.lift.slots, packing.pads, packing.protection, packing.fitted_case}));
    pack->files.insert(pack->files.begin(), start_here(*pack, foams.object_name, tools.language));
    return pack;
}

}  // namespace snug
