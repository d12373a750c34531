#include "snug/check/gap.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "snug/check/gap_space.h"
#include "snug/check/gap_volumes.h"
#include "snug/check/largest_ball.h"
#include "snug/check/line_hits.h"
#include "snug/mesh/triangle_tree.h"

namespace snug {
namespace {

std::vector<Vec3d> placed_vertices(const Mesh& mesh, const Placement& placement) {
    std::vector<Vec3d> placed;
    placed.reserve(mesh.vertices.size());
    for (const Vec3f& v : mesh.vertices) placed.push_back(placement(v));
    return placed;
}

double cut_volume(const BlockMap& blocks, const DesignSpace& space) {
    long long count = 0;
    for (const CutRun& run : blocks) count += run.blocks();
    return static_cast<double>(count) * space.block_volume();
}

void report_volumes(GapReport& report, GapSampler& sampler, bool closed) {
    sampler.finish();
    const GapVolumes volumes = sampler.volumes();
    const GapVolumes errors = sampler.errors();
    const auto [lower, upper] = sampler.halves();
    report.lower.step_mm3 = lower.step;
    report.upper.step_mm3 = upper.step;
    report.columns = sampler.columns(closed);
    report.hull_mm3 = volumes.hull;
    report.step_mm3 = volumes.step;
    report.error_mm3 = std::max(errors.hull, errors.step);
    if (!closed) return;
    report.solid_mm3 = volumes.solid;
    report.undercut_mm3 = volumes.undercut;
    report.lower.undercut_mm3 = lower.undercut;
    report.upper.undercut_mm3 = upper.undercut;
    report.error_mm3 = std::max({report.error_mm3, errors.solid, errors.undercut});
}

/// The cut below the parting level and the cut above it.
std::pair<BlockMap, BlockMap> parted(const BlockMap& blocks, int parting_level) {
    const auto level = static_cast<std::int16_t>(parting_level);
    BlockMap below = blocks, above = blocks;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        below[i].end = std::min(below[i].end, level);
        above[i].first = std::max(above[i].first, level);
    }
    return {std::move(below), std::move(above)};
}

struct GapSurface {
    const TriangleTree& tree;
    const std::vector<Vec3d>& placed;
    const LineLattice& lattice;
    const PrismField* hull;
    const LargestBallOptions& options;
};

/// `into`: the whole or a half of the report.
template <class Part>
Result<void> find_widest(const GapSurface& surface, const PrismField& cut, const Progress& progress,
                         Part& into) {
    const GapSpace gap(cut, surface.tree, surface.placed, surface.lattice, surface.hull);
    const Result<LargestBall> ball = largest_ball(gap, cut.bounds(), surface.options, progress);
    if (!ball) return tl::unexpected<Error>(ball.error());
    into.widest_mm = 2 * ball->radius;
    into.widest_error_mm = 2 * ball->radius_error;
    into.widest_at = ball->centre;
    return {};
}

void add(std::optional<double>& sum, const std::optional<double>& more) {
    if (sum && more)
        *sum += *more;
    else
        sum.reset();
}

template <class Part>
void take_wider(Part& widest, const Part& other) {
    if (other.widest_mm <= widest.widest_mm) return;
    widest.widest_mm = other.widest_mm;
    widest.widest_error_mm = other.widest_error_mm;
    widest.widest_at = other.widest_at;
}

void add(HalfGap& sum, const HalfGap& more) {
    sum.step_mm3 += more.step_mm3;
    add(sum.undercut_mm3, more.undercut_mm3);
    take_wider(sum, more);
}

void add(GapFigures& sum, const GapFigures& more) {
    sum.lines_per_column = std::min(sum.lines_per_column, more.lines_per_column);
    sum.cut_mm3 += more.cut_mm3;
    sum.hull_mm3 += more.hull_mm3;
    add(sum.solid_mm3, more.solid_mm3);
    sum.step_mm3 += more.step_mm3;
    add(sum.undercut_mm3, more.undercut_mm3);
    sum.error_mm3 += more.error_mm3;
    take_wider(sum, more);
    add(sum.lower, more.lower);
    add(sum.upper, more.upper);
}

}  // namespace

GapFigures united(const std::vector<GapReport>& layers) {
    GapFigures all = layers.front();
    for (std::size_t i = 1; i < layers.size(); ++i) add(all, layers[i]);
    return all;
}

Result<GapReport> gap_report(const Mesh& mesh, const Placement& placement, const DesignSpace& space,
                             const BlockMap& blocks, int parting_level, bool closed, const Progress& progress,
                             const GapLimits& limits) {
    GapReport report;
    report.cut_mm3 = cut_volume(blocks, space);

    const std::vector<Vec3d> placed = placed_vertices(mesh, placement);
    const LineLattice lattice = lattice_within(limits.lines, space, placed, mesh.triangles);
    report.lines_per_column = lattice.lines_per_column();
    GapSampler sampler(blocks, space, lattice, parting_level);
    std::optional<HullSampler> hull_sampler;
    if (!closed) hull_sampler.emplace(space, lattice);
    const Result<void> swept = sweep_lines(
        lattice, placed, mesh.triangles,
        [&](const LineBand& band) {
            sampler.add(band);
            if (hull_sampler) hull_sampler->add(band);
        },
        part_of(progress, 0, 0.4));
    if (!swept) return tl::unexpected<Error>(swept.error());
    report_volumes(report, sampler, closed);

    const Result<TriangleTree> tree =
        TriangleTree::build(placed, mesh.triangles, part_of(progress, 0.4, 0.5));
    if (!tree) return tl::unexpected<Error>(tree.error());
    std::optional<PrismField> hull;
    if (hull_sampler) hull.emplace(hull_sampler->take());
    const GapSurface surface{*tree, placed, lattice, hull ? &*hull : nullptr, limits.ball};
    if (auto done = find_widest(surface, cut_field(blocks, space), part_of(progress, 0.5, 0.7), report);
        !done)
        return tl::unexpected<Error>(done.error());
    const auto [below, above] = parted(blocks, parting_level);
    if (auto done = find_widest(surface, cut_field(below, space), part_of(progress, 0.7, 0.85), report.lower);
        !done)
        return tl::unexpected<Error>(done.error());
    if (auto done = find_widest(surface, cut_field(above, space), part_of(progress, 0.85, 1), report.upper);
        !done)
        return tl::unexpected<Error>(done.error());
    // A ball of a half lies in the whole gap as well.
    for (const HalfGap* half : {&report.lower, &report.upper}) {
        if (half->widest_mm <= report.widest_mm) continue;
        const double most = report.widest_mm + report.widest_error_mm;
        report.widest_mm = half->widest_mm;
        report.widest_at = half->widest_at;
        report.widest_error_mm = std::max(most - report.widest_mm, 0.0);
    }
    return report;
}

}  // namespace snug
