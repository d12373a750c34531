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
#include "snug/words/pieces.h"

namespace snug {
namespace {

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
            {say(layout.build.half == Half::lower ? "figure.bricks_lower" : "figure.bricks_lid"),
             bricks == 0 ? say("figure.none")
                         : say("figure.bricks_in_pieces", {{"bricks", bricks}, {"pieces", layout.pieces}})});
    }
    pack.figures.push_back({say("figure.kinds"), as_it_is(grouped(counts.size()))});
    pack.material.pieces = static_cast<long long>(pieces);
    pack.material.foam_kg = mass_g(counts) * 1e-3;
}

/// Bricks of a layer hold together by the next one alone: what is one layer thick cannot be one piece.
void tell_pieces(const BrickLayout& layout, std::vector<Finding>& findings) {
    if (layout.pieces <= 1) return;
    findings.push_back({Severity::warning, say("brick_pieces", {{"half", half_of(layout.build.half)},
                                                                {"pieces", layout.pieces}})});
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
    if (gap_mm > 0) pack.findings.push_back({Severity::note, say("lid_gap", {{"mm", number(gap_mm, 1)}})});
    pack.findings.push_back({Severity::note, say("rigid/bricks")});
}

/// Single studs never hold on to each other side by side.
std::optional<Error> cannot_join(const BrickOptions& options) {
    const bool longer = std::any_of(options.family.begin(), options.family.end(),
                                    [](const std::string& size) { return brick_size(size)->length > 1; });
    if (options.family.empty() || longer) return {};
    return Error{ErrorKind::usage, say("bricks.single_studs")};
}

}  // namespace

Result<WorkshopPack> brick_pack(const FoamDesign& design, const WorkshopOptions& workshop,
                                const LpSolver& solve, const Progress& progress) {
    if (design.foams.layers() > 1)
        return fail(ErrorKind::usage, say("bricks.layers", {{"ways", ways_for_layers()}}));
    const BrickOptions& options = workshop.bricks;
    if (const auto problem = problem_of(options)) return fail(ErrorKind::usage, problem->message);
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
    BrickPlan plan =
        brick_plan(halves, {design.object_name, design.language, pack.figures, !design.foams.open(), gap},
                   paper_mm(workshop.paper));
    pack.documents.push_back(std::move(plan.document));
    if (plan.cut_short) pack.findings.push_back({Severity::note, say("many_steps")});
    return pack;
}

}  // namespace snug
