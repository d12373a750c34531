#include "snug/search/protecting_walls.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "snug/base/text.h"
#include "snug/check/protection.h"
#include "snug/words/sides.h"

namespace snug {
namespace {

constexpr double kWallStep = 5;    // mm
constexpr double kGreatest = 400;  // mm
constexpr int kMostRounds = 60;

std::optional<Error> lacking(const Design& design) {
    if (auto error = lacking_for_shocks(design, say("protect.wish/walls"))) return error;
    if (design.space.blocks || design.case_options.inside_mm)
        return Error{ErrorKind::usage, say("protect.not_fitted", {{"option", "--blocks auto"}})};
    return {};
}

/// How much more foam a side needs; 0: it has enough.
double more_on(Side side, const Protection& found) {
    double more = 0;
    for (const ItemProtection& item : found.items) {
        const FaceShock& face = item.faces[static_cast<std::size_t>(side)];
        if (face.g_high && *face.g_high <= *item.asked_g) continue;
        // Where items reach one another it is not known at once.
        more = std::max(more, face.more_foam_mm.value_or(2 * kWallStep));
    }
    return more;
}

/// What stands in the way where no wall would do.
Error too_thick(Side side, const Protection& found) {
    const std::string cm = number(*found.drop_mm / 10, 0);
    const Message fallen = fallen_on(side);
    const bool items_meet = std::any_of(
        found.items.begin(), found.items.end(),
        [&](const ItemProtection& item) { return item.faces[static_cast<std::size_t>(side)].meets_item; });
    if (items_meet)
        return {ErrorKind::does_not_fit, say("protect.items_meet", {{"cm", cm}, {"fallen", fallen}})};
    return {ErrorKind::does_not_fit,
            say("protect.too_thick", {{"cm", cm}, {"fallen", fallen}, {"most", number(kGreatest, 0)}})};
}

}  // namespace

Result<Walls> protecting_walls(std::span<const Object> objects, const Design& design, const PackIt& pack_it,
                               const Progress& progress) {
    if (const auto error = lacking(design)) return tl::unexpected(*error);
    Design tried = design;
    const double least = std::ceil(design.protection.foam->least_thickness_mm() / kWallStep) * kWallStep;
    Walls walls = equal_walls(least);
    for (int round = 0; round < kMostRounds; ++round) {
        if (!go_on(progress, static_cast<double>(round) / kMostRounds))
            return fail(ErrorKind::cancelled, say("cancelled"));
        tried.space.wall_mm = walls;
        auto packing = pack_it(tried);
        if (!packing) return tl::unexpected(packing.error());
        const auto found = protection(objects, *packing, tried);
        if (!found) return tl::unexpected(found.error());
        if (!found->drop_mm) return fail(ErrorKind::usage, say("no_shock/height"));
        bool enough = true;
        for (int side = 0; side < 6; ++side) {
            const double more = more_on(static_cast<Side>(side), *found);
            double& wall = walls[static_cast<std::size_t>(side)];
            enough = enough && more == 0;
            wall += more;
            if (wall > kGreatest) return tl::unexpected(too_thick(static_cast<Side>(side), *found));
        }
        if (enough) return walls;
    }
    return fail(ErrorKind::does_not_fit, say("protect.none"));
}

}  // namespace snug
