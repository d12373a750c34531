#include "snug/search/greedy_climb.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "snug/base/text.h"
#include "snug/check/fit_report.h"
#include "snug/foam/foams.h"
#include "snug/foam/object_cut.h"
#include "snug/space/available.h"
#include "snug/space/case_space.h"
#include "snug/space/fitted_space.h"
#include "snug/space/placement.h"

namespace snug {
namespace {

/// The report for one rotation; none where the grown object leaves the space.
std::optional<FitReport> evaluate(Climb& climb, const PreparedSurface& surface, Vec3d rotation_deg) {
    ++climb.evaluations;
    const Placement placement = place(surface, rotation_deg, climb.offset_mm);
    const Vec3d least =
        fitted_blocks(grown(placement.bounds, climb.cut.whole_clearance_mm()), climb.space.block_mm);
    for (int axis = 0; axis < 3; ++axis)
        if (least[axis] > climb.space.blocks[axis]) return {};
    const ObjectDepths depths = object_depths(surface, placement, climb.space, climb.cut);
    const BlockMap blocks = object_cut(half_cuts(depths, climb.space), climb.space, placement.bounds);
    // Where the halves meet changes neither the walls nor what is cut.
    const Foams foams = split(blocks, 0, climb.available);
    const FitReport fit = fit_report(foams, {&blocks, 1}, climb.space, climb.available);
    if (fit.outside_blocks > 0) return {};
    return fit;
}

bool keeps_walls(const FitReport& fit, const std::array<double, 6>& least_wall) {
    for (std::size_t side = 0; side < least_wall.size(); ++side)
        if (fit.wall_mm[side] < least_wall[side]) return false;
    return true;
}

void stand_at(Climb& climb, Vec3d rotation_deg, const FitReport& fit) {
    climb.rotation_deg = rotation_deg;
    climb.cut_blocks = fit.cut_blocks;
    climb.fill_ratio = fit.fill_ratio;
}

/// The same direction within -180 to 180.
double wrapped(double degrees) {
    const double turn = std::fmod(degrees, 360);
    return turn > 180 ? turn - 360 : turn < -180 ? turn + 360 : turn;
}

}  // namespace

Result<Climb> start_climb(const PreparedSurface& surface, const Design& design, const DesignSpace& space) {
    Climb climb;
    climb.space = space;
    climb.cut = design.cut;
    climb.offset_mm = design.placement.offset_mm;
    climb.available = all_blocks(space.blocks);
    if (design.case_options.inside_mm)
        if (const auto fitted = case_space(design.case_options, design.space.block_mm))
            climb.available = available_blocks(*fitted);
    const auto fit = evaluate(climb, surface, design.placement.rotation_deg);
    if (!fit)
        return fail(ErrorKind::does_not_fit,
                    say("search.leaves_space", {{"space", dimensions(space.size())}}));
    stand_at(climb, design.placement.rotation_deg, *fit);
    const Walls wanted = wanted_wall_mm(design.space);
    for (std::size_t side = 0; side < climb.least_wall.size(); ++side)
        climb.least_wall[side] = std::min(wanted[side], fit->wall_mm[side]);
    return climb;
}

bool climb_round(Climb& climb, const PreparedSurface& surface, const ClimbProgress& progress) {
    const Vec3d from = climb.rotation_deg;
    bool moved = false;
    for (int angle = 0; angle < 3; ++angle) {
        for (const double direction : {1.0, -1.0}) {
            Vec3d rotation = from;
            rotation[angle] = wrapped(rotation[angle] + direction * climb.step_deg);
            const auto fit = evaluate(climb, surface, rotation);
            if (fit && fit->cut_blocks < climb.cut_blocks && keeps_walls(*fit, climb.least_wall)) {
                stand_at(climb, rotation, *fit);
                moved = true;
            }
            if (progress && !progress(climb)) return false;
        }
    }
    if (!moved) climb.step_deg /= 2;
    return true;
}

Result<Climb> greedy_climb(const Mesh& mesh, const Design& design, const DesignSpace& space,
                           const ClimbProgress& progress) {
    const PreparedSurface surface = prepare_surface(mesh);
    auto climb = start_climb(surface, design, space);
    if (!climb) return climb;
    while (!ended(*climb))
        if (!climb_round(*climb, surface, progress)) break;
    return climb;
}

}  // namespace snug
