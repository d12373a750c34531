#include "snug/fabricate/print/print.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "snug/base/text.h"
#include "snug/drawing/page_builder.h"
#include "snug/fabricate/kit/fit_test.h"
#include "snug/fabricate/kit/piece_names.h"
#include "snug/fabricate/print/print_labels.h"
#include "snug/fabricate/printing/print_joints.h"
#include "snug/fabricate/printing/print_parts.h"
#include "snug/fabricate/printing/print_solid.h"
#include "snug/fabricate/printing/print_things.h"
#include "snug/words/pieces.h"

namespace snug {
namespace {

constexpr double kFitTestHeight = 3;  // mm

struct PrintedHalf {
    std::vector<PrintThing> parts;
    std::vector<Bore> bores;
    int without_joint = 0;
    long long blocks = 0;
    int overhanging = 0;  ///< parts whose floor is no plane
    std::string places;   ///< lines of print/parts.csv
    std::vector<std::string> cut_labels;
    double letters_mm3 = 0;
};

int greatest(const Grid<Run>& kept) {
    int levels = 0;
    for (const Run run : kept) levels = std::max<int>(levels, run.end);
    return levels;
}

std::string csv_range(int first, int count) {
    return "," + std::to_string(first + 1) + "," + std::to_string(first + count);
}

std::string csv_line(const std::string& name, const PrintPart& part) {
    return name + csv_range(part.first.x, part.levels()) + csv_range(part.first.y, part.runs.ny()) +
           csv_range(part.first.z, part.runs.nz()) + "," + std::to_string(part.blocks()) + "\n";
}

/// Where each part belongs, numbered from 1: levels from the half's floor, rows from BACK, columns from the
/// left with the cavity facing the reader.
PackFile parts_list(const std::string& lines) {
    return text_file(
        "print/parts.csv",
        "part,first_level,last_level,first_row,last_row,first_column,last_column,blocks\n" + lines);
}

/// Those of the items that lie in a piece.
std::vector<ItemLabel> labels_on_piece(Piece piece, std::span<const ItemLabel> labels) {
    std::vector<ItemLabel> own;
    for (const ItemLabel& label : labels)
        if (label.layer == piece.index + 1) own.push_back(label);
    return own;
}

/// Cut apart and meshed; `name` stands before the numbers of its parts.
Result<PrintedHalf> printed_half(const Grid<Run>& kept, Vec3d block_mm, const PrintOptions& options,
                                 Piece piece, const std::string& name,
                                 std::span<const ItemLabel> labels = {}) {
    const PrintCuts cuts = print_cuts({greatest(kept), kept.ny(), kept.nz()}, block_mm, options.bed_mm);
    if (auto few = check_part_count(cuts, options.bed_mm); !few) return tl::unexpected(few.error());
    const PrintLayout layout = print_layout(kept, cuts);
    if (auto few = check_part_count(layout, options.bed_mm); !few) return tl::unexpected(few.error());

    PrintedHalf half;
    if (options.dowels) {
        Joints joints = place_joints(layout, block_mm, options);
        half.bores = std::move(joints.bores);
        half.without_joint = joints.without;
    }
    PrintLabels letters = print_labels(labels, layout, kept, block_mm);
    half.cut_labels = std::move(letters.cut);
    half.letters_mm3 = letters.volume_mm3;
    for (std::size_t i = 0; i < layout.parts.size(); ++i) {
        half.parts.push_back(
            {name + "-" + two_digits(i + 1), piece_color(piece),
             part_solid(layout, static_cast<int>(i), half.bores, block_mm, options,
                        {piece.half() == Half::lid, layout.cuts.turned}, letters.of_part[i])});
        half.blocks += layout.parts[i].blocks();
        half.overhanging += layout.parts[i].overhangs;
        half.places += csv_line(half.parts.back().name, layout.parts[i]);
    }
    return half;
}

/// The ring of a fit test, a flat piece seen as the lower foam is.
Result<void> add_fit_test(const FoamDesign& design, const LayerTest& layer, const PrintOptions& options,
                          WorkshopPack& pack) {
    const FitTest& test = layer.test;
    Grid<Run> kept(test.ring.ny(), test.ring.nz());
    std::transform(test.ring.begin(), test.ring.end(), kept.begin(), [](char foam) {
        return Run{0, static_cast<std::int16_t>(foam ? 1 : 0)};
    });
    PrintOptions flat = options;
    flat.dowels = false;
    const Vec3d block{std::min(kFitTestHeight, options.bed_mm.z), design.space.block_mm.y,
                      design.space.block_mm.z};
    const std::string stem = fit_test_stem(design, layer.layer);
    const auto ring = printed_half(kept, block, flat, Half::lower, stem);
    if (!ring) return tl::unexpected(ring.error());
    if (ring->parts.empty()) return {};
    add_beds(ring->parts, options.bed_mm,
             text(say("print.fit_title", {{"name", design.object_name}}), design.language), "print", stem,
             pack);
    add_stls(ring->parts, "print", pack);
    pack.figures.push_back({say("figure.fit_test"),
                            say("figure.flat_parts",
                                {{"parts", ring->parts.size()}, {"layer", std::to_string(test.level + 1)}})});
    return {};
}

/// Of pieces that lie on the case and of those that have a cavity below.
void tell_overhang(const std::vector<Piece>& pieces, const std::vector<PrintedHalf>& printed, bool middle,
                   const PrintOptions& options, WorkshopPack& pack) {
    int parts = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (pieces[i].middle() == middle) parts += printed[i].overhanging;
    if (parts == 0) return;
    std::vector<Message> glue;
    if (options.dowels) glue.push_back(say("overhang.glue"));
    pack.findings.push_back(
        {Severity::note, say(middle ? "overhang/middle" : "overhang", {{"parts", parts}, {"glue", glue}})});
}

void tell_findings(const std::vector<Piece>& pieces, const std::vector<PrintedHalf>& printed,
                   const PrintOptions& options, WorkshopPack& pack) {
    if (options.rigid) pack.findings.push_back({Severity::note, say("rigid/print")});
    for (const bool middle : {false, true}) tell_overhang(pieces, printed, middle, options, pack);
    int without = 0;
    for (const PrintedHalf& half : printed) without += half.without_joint;
    if (without > 0) pack.findings.push_back(no_dowel_finding("no_dowel/foam", without, options));
    for (const PrintedHalf& half : printed)
        for (const std::string& words : half.cut_labels)
            pack.findings.push_back({Severity::note, say("label_cut", {{"label", words}})});
}

}  // namespace

Result<WorkshopPack> print_pack(const FoamDesign& design, const PrintOptions& options) {
    if (const auto problem = problem_of(options)) return fail(ErrorKind::usage, problem->message);
    const Vec3d block = design.space.block_mm;
    if (!holds_block(options.bed_mm, block))
        return fail(ErrorKind::usage,
                    say("print.small_bed", {{"bed", dimensions(options.bed_mm)},
                                            {"needed", dimensions({block.z, block.y, block.x})}}));
    WorkshopPack pack;
    const std::vector<Piece> pieces = design.foams.all();
    std::vector<PrintedHalf> printed;
    std::vector<PrintThing> things;
    std::size_t bores = 0;
    long long blocks = 0;
    double letters_mm3 = 0;
    std::string places;
    for (const Piece piece : pieces) {
        auto half = printed_half(design.seen(piece).kept, block, options, piece, pack_stem(piece),
                                 labels_on_piece(piece, design.labels));
        if (!half) return tl::unexpected(half.error());
        things.insert(things.end(), half->parts.begin(), half->parts.end());
        bores += half->bores.size();
        blocks += half->blocks;
        letters_mm3 += half->letters_mm3;
        places += half->places;
        pack.figures.push_back(
            {piece_text(piece, "figure.parts_lower", "figure.parts_middle", "figure.parts_lid"),
             as_it_is(std::to_string(half->parts.size()))});
        printed.push_back(std::move(*half));
    }
    const auto parts = static_cast<long long>(things.size());
    add_dowels(bores, options, things);
    const std::size_t beds = add_beds(
        things, options.bed_mm, text(say("print.title", {{"name", design.object_name}}), design.language),
        "print", "bed", pack);
    add_stls(things, "print", pack);
    pack.files.push_back(parts_list(places));

    if (bores > 0) pack.figures.push_back({say("figure.dowels"), dowels_text(bores, options)});
    pack.figures.push_back({say("figure.beds"), as_it_is(std::to_string(beds))});
    pack.material.pieces = parts + static_cast<long long>(bores);
    pack.material.litres = (static_cast<double>(blocks) * design.space.block_volume() -
                            2 * static_cast<double>(bores) * bore_volume_mm3(options) - letters_mm3) *
                           1e-6;  // printed solid
    for (const LayerTest& layer : fit_tests(design))
        if (auto done = add_fit_test(design, layer, options, pack); !done)
            return tl::unexpected(done.error());
    tell_findings(pieces, printed, options, pack);
    return pack;
}

}  // namespace snug
