#include "snug/fabricate/print/print.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "snug/base/text.h"
#include "snug/fabricate/kit/fit_test.h"
#include "snug/fabricate/printing/print_joints.h"
#include "snug/fabricate/printing/print_parts.h"
#include "snug/fabricate/printing/print_solid.h"
#include "snug/fabricate/printing/print_things.h"

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

/// Cut apart and meshed; `name` stands before the numbers of its parts.
Result<PrintedHalf> printed_half(const Grid<Run>& kept, Vec3d block_mm, const PrintOptions& options, bool lid,
                                 const std::string& name) {
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
    for (std::size_t i = 0; i < layout.parts.size(); ++i) {
        half.parts.push_back({name + "-" + two_digits(i + 1), lid ? kUpperOrange : kLowerBlue,
                              part_solid(layout, static_cast<int>(i), half.bores, block_mm, options,
                                         {lid, layout.cuts.turned})});
        half.blocks += layout.parts[i].blocks();
        half.overhanging += layout.parts[i].overhangs;
        half.places += csv_line(half.parts.back().name, layout.parts[i]);
    }
    return half;
}

/// The ring of the fit test, a flat piece seen as the lower foam is.
Result<void> add_fit_test(const FoamDesign& design, const PrintOptions& options, WorkshopPack& pack) {
    const auto test = fit_test(design);
    if (!test) return {};
    Grid<Run> kept(test->ring.ny(), test->ring.nz());
    std::transform(test->ring.begin(), test->ring.end(), kept.begin(), [](char foam) {
        return Run{0, static_cast<std::int16_t>(foam ? 1 : 0)};
    });
    PrintOptions flat = options;
    flat.dowels = false;
    const Vec3d block{std::min(kFitTestHeight, options.bed_mm.z), design.space.block_mm.y,
                      design.space.block_mm.z};
    const auto ring = printed_half(kept, block, flat, false, "fit-test");
    if (!ring) return tl::unexpected(ring.error());
    if (ring->parts.empty()) return {};
    add_beds(ring->parts, options.bed_mm,
             text(say("print.fit_title", {{"name", design.object_name}}), design.language), "print",
             "fit-test", pack);
    add_stls(ring->parts, "print", pack);
    pack.figures.push_back(
        {say("figure.fit_test"), say("figure.flat_parts", {{"parts", ring->parts.size()},
                                                           {"layer", std::to_string(test->level + 1)}})});
    return {};
}

void tell_findings(const PrintedHalf& lower, const PrintedHalf& lid, const PrintOptions& options,
                   WorkshopPack& pack) {
    if (options.rigid) pack.findings.push_back({Severity::note, say("rigid/print")});
    if (const int parts = lower.overhanging + lid.overhanging; parts > 0) {
        std::vector<Message> glue;
        if (options.dowels) glue.push_back(say("overhang.glue"));
        pack.findings.push_back({Severity::note, say("overhang", {{"parts", parts}, {"glue", glue}})});
    }
    const int without = lower.without_joint + lid.without_joint;
    if (without > 0) pack.findings.push_back(no_dowel_finding("no_dowel/foam", without, options));
}

}  // namespace

Result<WorkshopPack> print_pack(const FoamDesign& design, const PrintOptions& options) {
    if (const auto problem = problem_of(options)) return fail(ErrorKind::usage, problem->message);
    const Vec3d block = design.space.block_mm;
    const int levels = design.space.blocks.x;
    if (!holds_block(options.bed_mm, block))
        return fail(ErrorKind::usage,
                    say("print.small_bed", {{"bed", dimensions(options.bed_mm)},
                                            {"needed", dimensions({block.z, block.y, block.x})}}));
    const auto lower =
        printed_half(kept_runs(design.foams, Half::lower, levels), block, options, false, "lower");
    if (!lower) return tl::unexpected(lower.error());
    const auto lid = printed_half(kept_runs(design.foams, Half::lid, levels), block, options, true, "lid");
    if (!lid) return tl::unexpected(lid.error());

    WorkshopPack pack;
    std::vector<PrintThing> things = lower->parts;
    things.insert(things.end(), lid->parts.begin(), lid->parts.end());
    const std::size_t bores = lower->bores.size() + lid->bores.size();
    add_dowels(bores, options, things);
    const std::size_t beds = add_beds(
        things, options.bed_mm, text(say("print.title", {{"name", design.object_name}}), design.language),
        "print", "bed", pack);
    add_stls(things, "print", pack);
    pack.files.push_back(parts_list(lower->places + lid->places));

    const double litres = (static_cast<double>(lower->blocks + lid->blocks) * design.space.block_volume() -
                           2 * static_cast<double>(bores) * bore_volume_mm3(options)) *
                          1e-6;
    pack.figures.push_back({say("figure.parts_lower"), as_it_is(std::to_string(lower->parts.size()))});
    pack.figures.push_back({say("figure.parts_lid"), as_it_is(std::to_string(lid->parts.size()))});
    if (bores > 0) pack.figures.push_back({say("figure.dowels"), dowels_text(bores, options)});
    pack.figures.push_back({say("figure.beds"), as_it_is(std::to_string(beds))});
    pack.material.pieces = static_cast<long long>(lower->parts.size() + lid->parts.size()) + bores;
    pack.material.litres = litres;  // printed solid
    if (auto done = add_fit_test(design, options, pack); !done) return tl::unexpected(done.error());
    tell_findings(*lower, *lid, options, pack);
    return pack;
}

}  // namespace snug
