#include "snug/foam/gap.h"

#include <algorithm>
#include <vector>

#include "snug/foam/gap_space.h"
#include "snug/foam/gap_volumes.h"
#include "snug/foam/largest_ball.h"
#include "snug/foam/line_hits.h"
#include "snug/mesh/triangle_tree.h"

namespace snug {
namespace {

/// A stage of the work, from one fraction of the whole to another.
Progress stage(const Progress& progress, double from, double to) {
    if (!progress) return {};
    return [&progress, from, to](double fraction) { return progress(from + (to - from) * fraction); };
}

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

void report_volumes(GapReport& report, const GapSampler& sampler, bool closed) {
    const GapVolumes volumes = sampler.volumes();
    const GapVolumes errors = sampler.errors();
    report.hull_mm3 = volumes.hull;
    report.step_mm3 = volumes.step;
    report.error_mm3 = std::max(errors.hull, errors.step);
    if (!closed) return;
    report.solid_mm3 = volumes.solid;
    report.undercut_mm3 = volumes.undercut;
    report.error_mm3 = std::max({report.error_mm3, errors.solid, errors.undercut});
}

}  // namespace

Result<GapReport> gap_report(const Mesh& mesh, const Placement& placement, const DesignSpace& space,
                             const BlockMap& blocks, bool closed, const Progress& progress) {
    GapReport report;
    report.lines_per_column = LineLattice::kPerColumn * LineLattice::kPerColumn;
    report.cut_mm3 = cut_volume(blocks, space);

    const std::vector<Vec3d> placed = placed_vertices(mesh, placement);
    const LineLattice lattice(space);
    GapSampler sampler(blocks, space);
    std::optional<HullSampler> hull_sampler;
    if (!closed) hull_sampler.emplace(space);
    const Result<void> swept = sweep_lines(
        lattice, placed, mesh.triangles,
        [&](const LineBand& band) {
            sampler.add(band);
            if (hull_sampler) hull_sampler->add(band);
        },
        stage(progress, 0, 0.4));
    if (!swept) return tl::unexpected<Error>(swept.error());
    report_volumes(report, sampler, closed);

    const Result<TriangleTree> tree = TriangleTree::build(placed, mesh.triangles, stage(progress, 0.4, 0.5));
    if (!tree) return tl::unexpected<Error>(tree.error());
    std::optional<PrismField> hull;
    if (hull_sampler) hull.emplace(hull_sampler->take());
    const PrismField cut = cut_field(blocks, space);
    const GapSpace gap(cut, *tree, placed, lattice, hull ? &*hull : nullptr);
    const Result<LargestBall> ball = largest_ball(gap, cut.bounds(), {}, stage(progress, 0.5, 1));
    if (!ball) return tl::unexpected<Error>(ball.error());
    report.widest_mm = 2 * ball->radius;
    report.widest_error_mm = 2 * ball->radius_error;
    report.widest_at = ball->centre;
    return report;
}

}  // namespace snug
