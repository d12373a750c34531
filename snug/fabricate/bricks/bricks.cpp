#include "snug/fabricate/bricks/bricks.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/fabricate/bricks/brick_layout.h"
#include "snug/fabricate/bricks/brick_list.h"
#include "snug/fabricate/bricks/brick_plan.h"
#include "snug/fabricate/bricks/brick_shape.h"
#include "snug/fabricate/bricks/brick_statics_report.h"
#include "snug/fabricate/bricks/ldraw.h"

namespace snug {
namespace {

std::string half_name(Half half) {
    return half == Half::lower ? "lower half" : "lid";
}

/// Bricks where the blocks allow it and nothing else was chosen.
int plates_a_layer(const BlockInStuds& block, BrickUnit unit) {
    if (unit == BrickUnit::automatic) return block.plates % kPlatesInBrick == 0 ? kPlatesInBrick : 1;
    return unit == BrickUnit::brick ? kPlatesInBrick : 1;
}

struct BuiltHalves {
    std::array<BrickLayout, 2> layouts;  ///< lower, lid
    std::array<BrickShape, 2> shapes;
};

Result<BuiltHalves> built_halves(const FoamDesign& design, const BrickOptions& options) {
    const auto block = block_in_studs(design.space.block_mm, options.unit);
    if (!block) return tl::unexpected(block.error());
    BrickBox box(options);
    BuiltHalves built;
    for (const Half half : {Half::lower, Half::lid}) {
        const auto i = static_cast<std::size_t>(half);
        built.shapes[i] = brick_shape(design, half, *block, plates_a_layer(*block, options.unit));
        auto layout = brick_layout(built.shapes[i], options.rim, box);
        if (!layout) return tl::unexpected(layout.error());
        built.layouts[i] = std::move(*layout);
    }
    return built;
}

double mass_g(std::span<const BrickCount> counts) {
    double mass = 0;
    for (const BrickCount& each : counts) mass += each.pieces * each.part->mass_g;
    return mass;
}

void tell_figures(const BuiltHalves& built, std::span<const BrickCount> counts, WorkshopPack& pack) {
    std::size_t pieces = 0;
    for (const BrickLayout& layout : built.layouts) {
        const std::size_t bricks = layout.build.bricks.size();
        pieces += bricks;
        pack.figures.push_back(
            {layout.build.half == Half::lower ? "Bricks, lower" : "Bricks, lid",
             bricks == 0 ? "none"
                         : grouped(bricks) + " in " +
                               counted(static_cast<unsigned long long>(layout.pieces), "piece", "pieces")});
    }
    pack.figures.push_back({"Kinds of pieces", grouped(counts.size())});
    pack.material.pieces = static_cast<long long>(pieces);
    pack.material.foam_kg = mass_g(counts) * 1e-3;
}

/// Bricks of a layer hold together by the next one alone: what is one layer thick cannot be one piece.
void tell_pieces(const BrickLayout& layout, std::vector<Finding>& findings) {
    if (layout.pieces <= 1) return;
    findings.push_back(
        {Severity::warning,
         "brick_pieces",
         "the bricks of the " + half_name(layout.build.half) + " hold together in " +
             grouped(static_cast<unsigned long long>(layout.pieces)) +
             " pieces: foam that is one layer thick, or islands of it, cannot be joined by studs. "
             "Glue it, take plates (--brick-unit plate) or more walls",
         {}});
}

/// Where neither half has a rim nothing meets.
double lid_gap_mm(const BuiltHalves& built, const BrickOptions& options) {
    if (options.rim == BrickRim::tiles) return 0;
    const auto has_rim = [](const BrickShape& shape) {
        return std::find(shape.rim.begin(), shape.rim.end(), 1) != shape.rim.end();
    };
    return has_rim(built.shapes[0]) && has_rim(built.shapes[1]) ? 2 * kStudHeight : 0;
}

void tell_findings(const BuiltHalves& built, double gap_mm, WorkshopPack& pack) {
    for (const BrickLayout& layout : built.layouts) tell_pieces(layout, pack.findings);
    if (gap_mm > 0)
        pack.findings.push_back({Severity::note,
                                 "lid_gap",
                                 "the rims meet stud on stud, so the lid stands " + number(gap_mm, 1) +
                                     " mm off and the whole is as much higher; --brick-rim tiles closes it",
                                 {}});
    pack.findings.push_back({Severity::note,
                             "rigid",
                             "bricks hold the object but are no cushion: put foam between them and the outer "
                             "box",
                             {}});
}

/// Single studs never hold on to each other side by side.
std::optional<Error> cannot_join(const BrickOptions& options) {
    const bool longer = std::any_of(options.family.begin(), options.family.end(),
                                    [](const std::string& size) { return brick_size(size)->length > 1; });
    if (options.family.empty() || longer) return {};
    return Error{ErrorKind::usage,
                 "bricks of 1x1 alone stand side by side without a hold: add 1x2 or longer to --brick-sizes"};
}

}  // namespace

Result<WorkshopPack> brick_pack(const FoamDesign& design, const WorkshopOptions& workshop,
                                const LpSolver& solve, const Progress& progress) {
    const BrickOptions& options = workshop.bricks;
    if (const auto problem = problem_of(options)) return fail(ErrorKind::usage, problem->sentence);
    if (auto error = cannot_join(options)) return tl::unexpected(std::move(*error));
    const auto built = built_halves(design, options);
    if (!built) return tl::unexpected(built.error());
    const std::array<ColoredBuild, 2> halves{
        ColoredBuild{&built->layouts[0].build, brick_color(options.lower_color)},
        ColoredBuild{&built->layouts[1].build, brick_color(options.lid_color)}};
    const std::vector<BrickCount> counts = brick_counts(halves);

    WorkshopPack pack;
    tell_figures(*built, counts, pack);
    const double gap = lid_gap_mm(*built, options);
    tell_findings(*built, gap, pack);
    for (const BrickLayout& layout : built->layouts) {
        const double begin = layout.build.half == Half::lower ? 0 : 0.5;
        const auto statics =
            brick_statics(layout.build, options.capacity_n, solve, part_of(progress, begin, begin + 0.5));
        if (!statics) return tl::unexpected(statics.error());
        tell_statics(layout.build, design.space, *statics, pack);
    }
    pack.files.push_back(text_file("bricks/foams.mpd", ldraw_file(halves, design.object_name)));
    pack.files.push_back(text_file("bricks/parts.csv", parts_csv(counts)));
    pack.files.push_back(text_file("bricks/wanted.xml", wanted_xml(counts)));
    BrickPlan plan = brick_plan(halves, {design.object_name, pack.figures, gap}, paper_mm(workshop.paper));
    pack.documents.push_back(std::move(plan.document));
    if (plan.cut_short)
        pack.findings.push_back(
            {Severity::note,
             "many_steps",
             "the steps would fill more pages than anyone prints, so bricks-plan.pdf leaves "
             "the later ones out: build by bricks/foams.mpd",
             {}});
    return pack;
}

}  // namespace snug
