#include "snug/fabricate/kit/output_files.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "snug/base/stopwatch.h"
#include "snug/base/text.h"
#include "snug/drawing/page_builder.h"
#include "snug/fabricate/kit/piece_names.h"
#include "snug/fabricate/kit/shock_text.h"
#include "snug/formats/mesh_files.h"
#include "snug/picture/preview.h"
#include "snug/solid/solid.h"
#include "snug/space/available.h"
#include "snug/space/placed_mesh.h"

namespace snug {
namespace {

FileBytes foam_file(const Solid& solid, const std::string& format, Piece piece) {
    if (format == "ply") return write_ply(solid.vertices, solid.triangles, piece_color(piece));
    const std::string name =
        piece.middle() ? "middle foam " + std::to_string(piece.index) : foam_stem(piece) + " foam";
    return write_stl(solid.vertices, solid.triangles, "Snug " + name + ", mm");
}

Message caption(const Packing& packing, const std::string& object_name) {
    const FitReport& fit = packing.fit;
    double thinnest = fit.wall_mm[kFloor];
    for (std::size_t side = 0; side < fit.wall_mm.size(); ++side)
        if (!fit.open || side != kRoof) thinnest = std::min(thinnest, fit.wall_mm[side]);
    return say("preview.caption", {{"name", object_name},
                                   {"blocks", dimensions(vec_cast<double>(packing.space.blocks), 0)},
                                   {"block", dimensions(packing.space.block_mm)},
                                   {"wall", number(thinnest, 1)},
                                   {"litres", number(fit.foam_mm3 * 1e-6, 1)}});
}

}  // namespace

std::string depths_csv(const Foams& foams, const Grid<Run>& available, int nx) {
    const bool shortened = !fills_box(available, nx);
    const Grid<Run>& below = foams.piece(foams.at(0));
    const Grid<Run> above = kept_runs(foams, Half::lid, nx);
    std::string text = "j,k,lower_blocks,upper_blocks";
    if (shortened) text += ",lower_first,upper_first";
    for (int i = 1; i < foams.layers(); ++i)
        text += ",middle_" + std::to_string(i) + "_blocks,middle_" + std::to_string(i) + "_first";
    text += "\n";
    const auto add = [&](int value) { text += "," + std::to_string(value); };
    for (int j = 0; j < below.ny(); ++j)
        for (int k = 0; k < below.nz(); ++k) {
            const Run lower = below(j, k), upper = above(j, k);  // counted from +x
            text += std::to_string(j);
            add(k);
            add(lower.blocks());
            add(upper.blocks());
            if (shortened) {
                add(lower.first);
                add(upper.none() ? nx : nx - upper.end);
            }
            for (int i = 1; i < foams.layers(); ++i) {
                const Run middle = foams.piece(foams.at(i))(j, k);
                add(middle.blocks());
                add(middle.first);
            }
            text += "\n";
        }
    return text;
}

std::string preview_of(std::span<const Object> objects, const Project& project, const Made& made) {
    const Packing& packing = made.packing;
    const std::deque<PlacedMesh> meshes = placed_layers(objects, packing.items, packing.foams->layers());
    std::vector<PreviewLayer> layers;
    for (std::size_t i = 0; i < meshes.size(); ++i)
        layers.push_back({meshes[i].mesh(), meshes[i].placement(),
                          made.fit.gap ? &made.fit.layer_gaps[i] : nullptr,
                          numbered_places(packing.items, static_cast<int>(i) + 1)});
    const auto& drops = packing.protection;
    const auto falls = drops && drops->drop_mm && drops->foam
                           ? std::optional(PreviewFalls{*drops, text(drop_text(*drops), made.language)})
                           : std::nullopt;
    return preview_svg(*packing.foams, packing.space, layers,
                       text(caption(packing, names_of_items(project)), made.language), made.language,
                       falls ? &*falls : nullptr);
}

Result<void> make_output_files(std::span<const Object> objects, const Project& project, Made& made,
                               const TakeFile& take) {
    Packing& packing = made.packing;
    const Foams& foams = *packing.foams;
    packing.timing.solids = 0;
    for (const Piece piece : foams.all()) {
        Stopwatch watch;
        const Solid solid = solid_of(foams, piece, packing.space);
        packing.timing.solids += watch.lap();
        for (const std::string& format : project.design.output.formats)
            if (auto done = take({foam_stem(piece) + "." + format, foam_file(solid, format, piece)}); !done)
                return done;
    }
    if (auto done =
            take(text_file("depths.csv", depths_csv(foams, packing.available, packing.space.blocks.x)));
        !done)
        return done;
    if (auto done = take(text_file("preview.svg", preview_of(objects, project, made))); !done) return done;
    return take(text_file("project.snug.json", project_json(project)));
}

}  // namespace snug
