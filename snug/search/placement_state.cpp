#include "snug/search/placement_state.h"

#include <cmath>
#include <limits>

#include "snug/base/parallel.h"
#include "snug/object/turned_bounds.h"
#include "snug/search/exact_cut.h"
#include "snug/search/searched_zones.h"

namespace snug {
namespace {

constexpr std::size_t kTurnsABatch = 64;
constexpr std::size_t kKept = 32;      ///< candidates that are kept from round to round
constexpr std::size_t kDecided = 4;    ///< candidates, and offsets of each, that are looked at exactly
constexpr double kDistinct = 0.99905;  ///< closeness of rotations 5 degrees apart
constexpr std::size_t kMostDiverse = 12;
// Evaluations in whose time shocks are estimated, and calculated in full.
constexpr long long kEstimateCost = 8, kFullCost = 100;

}  // namespace

using State = PlacementSearch::State;

/// The offsets that cut least, with scores that take gap and bearing to be as good as can be.
std::vector<PlacementCandidate> State::look(QuickCut& kernel, const PointsLevel& level, const Turn& turn,
                                            std::size_t most) const {
    const Rotation rotation = rotation_of(turn);
    const Box3d turned = turned_bounds(surface->body, rotation);
    PlacementMeasures hoped;
    hoped.depth_mm = turned.size().x;
    hoped.bearing = 1;
    hoped.steadiness = steadiness ? (*steadiness)(rotation) : 1;
    std::vector<PlacementCandidate> result;
    const Box3d kept_free = kept_free_by_zones(lying({rotation, {}, turned}, cut, zones));
    for (const OffsetCut& at : kernel.least(level.points, rotation, turned, most, kept_free)) {
        hoped.cut_blocks = static_cast<double>(at.blocks);
        result.push_back({turn, at, (*score)(hoped)});
    }
    return result;
}

/// What the exact kernel measures; none where walls are not kept.
std::optional<PlacementMeasures> State::exactly(Vec3d rotation_deg, Vec3d offset_mm) const {
    const auto exact = exact_cut(*surface, space, cut, rotation_deg, offset_mm, available, zones);
    if (!exact || !keeps_walls(exact->wall_mm, least_wall)) return {};
    PlacementMeasures result = measures(*exact, space);
    result.steadiness = steadiness ? (*steadiness)(exact->placement.rotation) : 1;
    if (shocks) result.margins = shocks->estimated(*exact);
    return result;
}

std::optional<State::Looked> State::looked_at(Vec3d rotation_deg, Vec3d offset_mm) const {
    const auto found = exactly(rotation_deg, offset_mm);
    if (!found) return {};
    return Looked{{rotation_deg, offset_mm, static_cast<long long>(found->cut_blocks), (*score)(*found),
                   found->bearing},
                  *found};
}

/// By whole blocks along each axis, away from the side where more is met, as long as the worse of the two
/// sides gets better. What is cut does not change with it.
State::Looked State::shifted(Looked from) const {
    for (int axis = 0; axis < 3; ++axis) {
        const auto low = static_cast<std::size_t>(2 * axis);
        const auto worse = [low](const Looked& at) {
            return std::max(at.measured.margins[low], at.measured.margins[low + 1]);
        };
        const bool up = from.measured.margins[low] > from.measured.margins[low + 1];
        for (;;) {
            Vec3d offset_mm = from.found.offset_mm;
            offset_mm[axis] += up ? space.block_mm[axis] : -space.block_mm[axis];
            const auto next = looked_at(from.found.rotation_deg, offset_mm);
            if (!next || !(worse(*next) < worse(from))) break;
            from = *next;
        }
    }
    return from;
}

/// With the score of the full calculation; none where it cannot be packed so.
std::optional<FoundPlacement> State::in_full(const Looked& looked) const {
    const auto margins = shocks->in_full(looked.found.rotation_deg, looked.found.offset_mm);
    if (!margins) return {};
    PlacementMeasures measured = looked.measured;
    measured.margins = *margins;
    FoundPlacement found = looked.found;
    found.score = (*full_score)(measured);
    return found;
}

/// The offset of the least score: where gap, bearing or shocks are weighed they need the exact kernel.
std::optional<PlacementCandidate> State::best_offset(QuickCut& kernel, const PointsLevel& level,
                                                     const Turn& turn) const {
    constexpr std::size_t kMeasured = 3;
    const bool several = score->weighs(Objective::gap) || score->weighs(Objective::bearing);
    const bool measured = several || shocks;
    const std::vector<PlacementCandidate> offsets =
        look(kernel, level, turn, measured ? most_offsets(several ? kMeasured : 1) : 1);
    if (!measured) return offsets.empty() ? std::optional<PlacementCandidate>() : offsets.front();
    std::optional<PlacementCandidate> best_one;
    const Vec3d rotation_deg = euler_of(rotation_of(turn));
    for (PlacementCandidate offset : offsets) {
        const auto found = exactly(rotation_deg, offset.cut.offset_mm);
        if (!found) continue;
        offset.score = (*score)(*found);
        if (!best_one || better(offset, *best_one)) best_one = offset;
    }
    return best_one;
}

/// Evaluations that so many rotations count as.
long long State::cost_of(std::size_t rotations) const {
    return static_cast<long long>(rotations) * (shocks ? kEstimateCost : 1);
}

/// The sequence's next rotations, one of each set of equals.
std::vector<Turn> State::next_spread() {
    std::vector<Turn> turns;
    if (!first.empty()) {
        turns.swap(first);
        return turns;
    }
    const std::size_t wanted = std::min(kTurnsABatch, left_in_round);
    while (turns.size() < wanted) {
        const Turn turn = allowed.spread(spread++, seed);
        if (closeness(symmetry->least_turned(turn), turn) > 1 - 1e-9) turns.push_back(turn);
    }
    left_in_round -= wanted;
    return turns;
}

/// Keeps the best, no two of them close to each other.
void State::keep(std::vector<PlacementCandidate>& list, const PlacementCandidate& candidate, std::size_t most,
                 double distinct) const {
    for (PlacementCandidate& other : list) {
        if (symmetry->closest(candidate.turn, other.turn) < distinct) continue;
        if (!better(candidate, other)) return;
        other = candidate;
        std::stable_sort(list.begin(), list.end(), better);
        return;
    }
    list.insert(std::upper_bound(list.begin(), list.end(), candidate, better), candidate);
    if (list.size() > most) list.pop_back();
}

void State::spread_step() {
    const std::vector<Turn> turns = next_spread();
    constexpr std::size_t kTurnsATask = 16;
    std::vector<std::optional<PlacementCandidate>> found(turns.size());
    parallel_for((turns.size() + kTurnsATask - 1) / kTurnsATask, [&](std::size_t task) {
        QuickCut quick = kernel(coarse);
        for (std::size_t i = task * kTurnsATask; i < std::min(turns.size(), (task + 1) * kTurnsATask); ++i)
            found[i] = best_offset(quick, coarse, turns[i]);
    });
    evaluations += cost_of(turns.size());
    const std::size_t most = 12 + 6 * round;
    for (const auto& candidate : found)
        if (candidate) keep(fresh, *candidate, most, kDistinct);
}

/// Small turns, ever smaller; each that is no worse is taken.
PlacementCandidate State::climb(PlacementCandidate from, const PointsLevel& level, std::uint64_t stream,
                                std::size_t tries, double widest, double least) const {
    SeededNumbers numbers(stream);
    QuickCut quick = kernel(level);
    if (const auto here = best_offset(quick, level, from.turn)) from = *here;
    double step = widest;
    const double shrink = std::sqrt(std::sqrt(least / widest));  // over a quarter of the tries
    const double rate = 1 - (1 - shrink) * 4 / static_cast<double>(tries);
    for (std::size_t i = 0; i < tries; ++i) {
        const Turn turn = allowed.small(numbers, step * numbers.between(0.3, 1)) * from.turn;
        const auto next = best_offset(quick, level, turn);
        if (next && next->score <= from.score) from = *next;
        step = std::max(least, step * rate);
    }
    return from;
}

void State::climb_step(std::vector<PlacementCandidate>& from, std::vector<PlacementCandidate>& to,
                       const PointsLevel& level, std::size_t tries, double widest, double least) {
    constexpr std::size_t kAtOnce = 4;
    const std::size_t count = std::min(kAtOnce, from.size());
    std::vector<PlacementCandidate> ends(count);
    parallel_for(count, [&](std::size_t i) {
        const std::uint64_t stream =
            seed * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(evaluations) * 64 + i;
        ends[i] = climb(from[i], level, stream, tries, widest, least);
    });
    from.erase(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(count));
    evaluations += cost_of(count * (tries + 1));
    for (const PlacementCandidate& end : ends) {
        keep(to, end, kKept, kDistinct);
        if (&level == &fine) keep(diverse, end, kMostDiverse, kDiverse);
    }
}

/// What the exact kernel finds among a rotation's offsets, the best by `score` first; none above `most`.
std::vector<State::Looked> State::decided(const PlacementCandidate& candidate, double most) const {
    // Where shocks are weighed shifts by whole blocks are still to come.
    const double before = shocks ? std::numeric_limits<double>::infinity() : most;
    std::vector<Looked> found;
    QuickCut quick = kernel(fine);
    const Vec3d rotation_deg = allowed.only_one()
                                   ? origin.rotation_deg
                                   : euler_of(rotation_of(symmetry->least_turned(candidate.turn)));
    for (const PlacementCandidate& at :
         look(quick, fine, turn_of(rotation_from_euler(rotation_deg)), most_offsets(kDecided))) {
        if (at.score > before) break;
        auto next = looked_at(rotation_deg, at.cut.offset_mm);
        if (next && shocks) next = shifted(*next);
        if (next && next->found.score <= most) found.push_back(*next);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Looked& a, const Looked& b) { return a.found < b.found; });
    return found;
}

/// Lets the exact kernel decide where the points do not refuse.
void State::decide(const PlacementCandidate& candidate) {
    if (shocks) return decide_in_full(candidate);
    if (candidate.score > best.score) return;
    ++evaluations;
    const auto found = decided(candidate, best.score);
    if (!found.empty() && found.front().found < best) best = found.front().found;
}

/// Lets the full calculation decide where the estimate does not refuse, once for each rotation: among the
/// most promising of its offsets.
void State::decide_in_full(const PlacementCandidate& candidate) {
    constexpr std::size_t kInFull = 2, kOfOneTurn = 16;
    for (const Turn& turn : settled)
        if (closeness(turn, candidate.turn) > 1 - 1e-12) return;
    settled.push_back(candidate.turn);
    evaluations += cost_of(kDecided);
    std::vector<Looked> looked = decided(candidate, best_estimate);
    looked.resize(std::min(looked.size(), allowed.only_one() ? kOfOneTurn : kInFull));
    for (const Looked& each : looked) {
        evaluations += kFullCost;
        const auto found = in_full(each);
        if (!found || !(*found < best)) continue;
        best = *found;
        best_estimate = each.found.score;
    }
}

void State::decide_best(const std::vector<PlacementCandidate>& list) {
    for (std::size_t i = 0; i < std::min(kDecided, list.size()); ++i) decide(list[i]);
}

}  // namespace snug
