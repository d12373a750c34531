#include "snug/search/rank_cases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "snug/base/rotation.h"
#include "snug/check/find_case_problems.h"
#include "snug/search/turn.h"
#include "snug/space/case_space.h"
#include "snug/space/fitted_space.h"

namespace snug {
namespace {

constexpr double kRounding = 1e-6;
constexpr double kUnknown = std::numeric_limits<double>::max();  // comes last

Vec3d laid(Vec3d size, const Lay& lay) {
    return {size[lay[0]], size[lay[1]], size[lay[2]]};
}

double volume(Vec3d size) {
    return size.x * size.y * size.z;
}

/// One case and one way to lay the object.
RankedCase tried(const KnownCase& known, const Design& design, const Cargo& cargo, const Lay& lay) {
    RankedCase ranked{known, lay, 0, billed_kg(known, cargo), {}};
    const Vec3d size = laid(cargo.size_mm, lay);
    const Walls walls = wanted_wall_mm(design.space);
    CaseOptions options = design.case_options;
    apply(known, options);
    const Clearance clearance = design.cut.whole_clearance_mm();
    const Box3d room = grown({size * -0.5, size * 0.5}, clearance);
    const auto fitted = problem_of(options) ? Result<CaseSpace>(tl::unexpected(Error()))
                                            : case_space(options, design.space.block_mm);
    const Vec3d block = fitted ? fitted->space.block_mm : design.space.block_mm;
    const Vec3d needed = fitted_blocks(room, block, walls);
    const Vec3d inside = least_inside(options, block, size, clearance, walls);
    for (int axis = 0; axis < 3; ++axis) {
        const bool fits = fitted && needed[axis] <= fitted->space.blocks[axis];
        const double lacking = inside[axis] - known.inside_mm[axis];
        ranked.lacking_mm[static_cast<std::size_t>(axis)] = fits ? 0 : std::max(lacking, kRounding);
    }
    if (fitted) {
        Vec3d taken;
        for (int axis = 0; axis < 3; ++axis) {
            const auto side = static_cast<std::size_t>(2 * axis);
            taken[axis] = room.size()[axis] + walls[side] + walls[side + 1];
        }
        ranked.fill = std::min(1.0, volume(taken) / volume(fitted->free.size()));
    }
    return ranked;
}

/// The way to lay the object that lacks least, the first of equals.
RankedCase best_lay(const KnownCase& known, const Design& design, const Cargo& cargo) {
    RankedCase best = tried(known, design, cargo, kLays[0]);
    for (const Lay& lay : kLays) {
        RankedCase other = tried(known, design, cargo, lay);
        if (other.lacking() < best.lacking()) best = std::move(other);
    }
    return best;
}

bool comes_before(const RankedCase& a, const RankedCase& b) {
    const auto key = [](const RankedCase& c) {
        return std::tuple(-c.fill, c.billed_kg.value_or(kUnknown), c.known.price.value_or(kUnknown));
    };
    return std::tuple(key(a), a.known.name) < std::tuple(key(b), b.known.name);
}

}  // namespace

Vec3d rotation_for(const Lay& lay, Vec3d rotation_deg) {
    if (lay == kLays[0]) return rotation_deg;
    const Rotation base = rotation_from_euler(rotation_deg);
    Rotation turned;
    // An odd exchange of axes is a rotation only with one of them turned round.
    const bool odd = lay == kLays[1] || lay == kLays[2] || lay == kLays[3];
    for (int axis = 0; axis < 3; ++axis)
        turned.row[static_cast<std::size_t>(axis)] =
            base.row[static_cast<std::size_t>(lay[static_cast<std::size_t>(axis)])];
    if (odd) {
        const std::size_t flipped = lay == kLays[1] ? 1 : 0;
        turned.row[flipped] = -turned.row[flipped];
    }
    return euler_of(turned);
}

std::optional<double> billed_kg(const KnownCase& known, const Cargo& cargo) {
    std::optional<double> billed;
    if (cargo.mass_kg) billed = *cargo.mass_kg + known.tare_kg.value_or(0);
    if (!known.has_flat_rate()) {
        const double cm3 = volume(known.inside_mm) * 1e-3;
        billed = std::max(billed.value_or(0), cm3 / known.divisor.value_or(cargo.divisor));
    }
    if (billed) *billed = std::ceil(*billed - kRounding);
    return billed;
}

CaseRanking rank_cases(const std::vector<KnownCase>& known, const Design& design, const Cargo& cargo) {
    CaseRanking ranking;
    ranking.least_inside_mm = least_inside(design.case_options, design.space.block_mm, cargo.size_mm,
                                           design.cut.whole_clearance_mm(), wanted_wall_mm(design.space));
    for (const KnownCase& one : known) {
        RankedCase ranked = best_lay(one, design, cargo);
        const bool fits = ranked.lacking() <= 0;
        if (fits && cargo.mass_kg && one.most_kg && *cargo.mass_kg + one.tare_kg.value_or(0) > *one.most_kg)
            ranking.too_weak.push_back(one);
        else if (fits)
            ranking.fitting.push_back(std::move(ranked));
        else if (!ranking.nearest || ranked.lacking() < ranking.nearest->lacking())
            ranking.nearest = std::move(ranked);
    }
    std::stable_sort(ranking.fitting.begin(), ranking.fitting.end(), comes_before);
    if (!ranking.fitting.empty()) ranking.nearest.reset();
    return ranking;
}

}  // namespace snug
