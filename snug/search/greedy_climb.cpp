#include "snug/search/greedy_climb.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "snug/base/text.h"
#include "snug/search/exact_cut.h"
#include "snug/space/available.h"
#include "snug/space/case_space.h"

namespace snug {
namespace {

/// One rotation; none where the object leaves the space.
std::optional<ExactCut> evaluate(Climb& climb, const PreparedSurface& surface, Vec3d rotation_deg) {
    ++climb.evaluations;
    return exact_cut(surface, climb.space, climb.cut, rotation_deg, climb.offset_mm, climb.available,
                     climb.zones);
}

void stand_at(Climb& climb, Vec3d rotation_deg, const ExactCut& exact) {
    climb.rotation_deg = rotation_deg;
    climb.cut_blocks = exact.cut_blocks;
    climb.fill_ratio = exact.fill_ratio;
}

/// The same direction within -180 to 180.
double wrapped(double degrees) {
    const double turn = std::fmod(degrees, 360);
    return turn > 180 ? turn - 360 : turn < -180 ? turn + 360 : turn;
}

}  // namespace

Result<Climb> start_climb(const PreparedSurface& surface, const Design& design, const DesignSpace& space,
                          const std::vector<ItemZone>& zones) {
    Climb climb;
    climb.space = space;
    climb.cut = design.cut;
    climb.zones = zones;
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
            if (fit && fit->cut_blocks < climb.cut_blocks && keeps_walls(fit->wall_mm, climb.least_wall)) {
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
                           const ClimbProgress& progress, const std::vector<ItemZone>& zones) {
    const PreparedSurface surface = prepare_surface(mesh);
    auto climb = start_climb(surface, design, space, zones);
    if (!climb) return climb;
    while (!ended(*climb))
        if (!climb_round(*climb, surface, progress)) break;
    return climb;
}

}  // namespace snug
