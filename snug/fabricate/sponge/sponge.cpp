#include "snug/fabricate/sponge/sponge.h"

#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "snug/base/text.h"
#include "snug/drawing/drawing_svg.h"
#include "snug/drawing/tiling.h"
#include "snug/fabricate/kit/piece_names.h"
#include "snug/fabricate/sponge/pluck_map.h"
#include "snug/fabricate/sponge/sponge_plan.h"
#include "snug/words/pieces.h"

namespace snug {
namespace {

constexpr std::size_t kMostMapPages = 600;  // more are printed by nobody

std::string padded(int value, int greatest) {
    std::string text = std::to_string(value);
    const std::size_t width = std::max<std::size_t>(2, std::to_string(greatest).size());
    return std::string(width - std::min(width, text.size()), '0') + text;
}

/// "sponge/lower-03.svg", "sponge/lid-04-06.svg"
std::string map_name(const PluckPlan& plan, const LayerRun& run) {
    return "sponge/" + pack_stem(plan.piece) + "-" + padded(run.first, plan.layers) +
           (run.layers() > 1 ? "-" + padded(run.last, plan.layers) : "") + ".svg";
}

PackFile svg_file(std::string name, const Drawing& drawing) {
    return text_file(std::move(name), drawing_svg(drawing));
}

/// The maps in the order of work: the fit test, then each half from its cavity's side.
struct Maps {
    std::vector<PackFile> files;
    DrawingDocument document;
    bool too_many = false;
};

/// On what maps are drawn.
struct MapPaper {
    MapSheets sheets;
    Vec2d size_mm;
};

Result<std::vector<Drawing>> pages_of(const Drawing& map, const MapPaper& paper) {
    if (paper.sheets == MapSheets::plotter) return std::vector{map};
    return tiled(map, paper.size_mm);
}

/// Adds a map as a file and, while there is room for its pages, to the document.
Result<void> add_map(const Drawing& map, std::string name, const MapPaper& paper, Maps& maps) {
    maps.files.push_back(svg_file(std::move(name), map));
    if (maps.too_many) return {};
    auto pages = pages_of(map, paper);
    if (!pages) return tl::unexpected(pages.error());
    auto& all = maps.document.pages;
    maps.too_many = all.size() + pages->size() > kMostMapPages;
    if (!maps.too_many)
        all.insert(all.end(), std::make_move_iterator(pages->begin()), std::make_move_iterator(pages->end()));
    return {};
}

Result<Maps> true_size_maps(const FoamDesign& design, const SpongeWork& work, const MapPaper& paper) {
    Maps maps;
    if (paper.sheets == MapSheets::none) return maps;
    const std::string title = text(say("sponge.maps_title", {{"name", design.object_name}}), design.language);
    maps.document = {"sponge-maps", title, {print_check_page(paper.size_mm, title, design.language)}, true};
    std::size_t test_pages = 1;
    for (const auto& [layer, test] : work.tests) {
        const Message name = design.foams.layers() == 1
                                 ? say("sponge.fit_test")
                                 : say("sponge.fit_test_of", {{"layer", std::to_string(layer)}});
        const Drawing map = fit_test_map(test, name, design);
        if (auto done = add_map(map, "sponge/" + fit_test_stem(design, layer) + ".svg", paper, maps); !done)
            return tl::unexpected(done.error());
        test_pages = maps.document.pages.size();
    }
    for (const PluckPlan& plan : work.plans)
        for (const LayerRun& run : plan.runs) {
            if (run.plucked + run.cut_off == 0) continue;
            const Drawing map = pluck_map(plan, run, design);
            if (auto done = add_map(map, map_name(plan, run), paper, maps); !done)
                return tl::unexpected(done.error());
        }
    // Some layers on paper and others not would mislead.
    if (maps.too_many) maps.document.pages.resize(test_pages);
    return maps;
}

Message blocks_text(const PluckPlan& plan) {
    if (plan.plucked == 0) return say("figure.nothing_to_pluck", {{"layers", plan.layers}});
    return say("figure.blocks_of_layers", {{"blocks", plan.plucked}, {"layers", plan.layers}});
}

/// As people write it.
Message paper_name(std::string_view paper) {
    if (paper == "letter") return say("paper.letter");
    return paper == "a3" ? say("paper.a3") : say("paper.a4");
}

Message maps_text(const Maps& maps, const WorkshopOptions& options) {
    if (options.sponge.maps == MapSheets::none) return say("figure.no_maps");
    const std::string count = std::to_string(maps.files.size());
    if (options.sponge.maps == MapSheets::plotter) return say("figure.maps_to_plot", {{"maps", count}});
    const std::size_t pages = maps.files.empty() ? 0 : maps.document.pages.size();
    return say("figure.maps_on_pages",
               {{"maps", count}, {"pages", std::to_string(pages)}, {"paper", paper_name(options.paper)}});
}

void tell_figures(const FoamDesign& design, const SpongeWork& work, const Maps& maps,
                  const WorkshopOptions& options, WorkshopPack& pack) {
    const double columns = static_cast<double>(design.available.size());
    int layers = 0;
    for (const PluckPlan& plan : work.plans) {
        layers += plan.layers;
        pack.figures.push_back(
            {piece_text(plan.piece, "figure.pluck_lower", "figure.pluck_middle", "figure.pluck_lid"),
             blocks_text(plan)});
    }
    pack.material.pieces = plucked_of(work);
    pack.material.litres = layers * columns * design.space.block_volume() * 1e-6;
    pack.figures.push_back({say("figure.maps"), maps_text(maps, options)});
}

}  // namespace

Result<WorkshopPack> sponge_pack(const FoamDesign& design, const WorkshopOptions& options) {
    SpongeWork work{{}, fit_tests(design)};
    for (const Piece piece : design.foams.all()) work.plans.push_back(pluck_plan(design, piece));
    auto maps = true_size_maps(design, work, {options.sponge.maps, paper_mm(options.paper)});
    if (!maps) return tl::unexpected(maps.error());

    WorkshopPack pack;
    pack.documents.push_back(
        {"sponge-plan", sponge_title(design), sponge_plan(design, work, paper_mm(options.paper)), false});
    tell_figures(design, work, *maps, options, pack);
    if (maps->too_many)
        pack.findings.push_back(
            {Severity::note, say("many_maps", {{"pages", std::to_string(kMostMapPages)}})});
    if (const long long off = cut_off_of(work); off > 0)
        pack.findings.push_back({Severity::note, say("cut_off/sponge", {{"blocks", off}})});
    if (!maps->files.empty()) pack.documents.push_back(std::move(maps->document));
    pack.files = std::move(maps->files);
    return pack;
}

}  // namespace snug
