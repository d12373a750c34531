#include "snug/search/placement_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "snug/base/parallel.h"
#include "snug/base/text.h"
#include "snug/object/turned_bounds.h"
#include "snug/search/exact_cut.h"
#include "snug/search/frames.h"
#include "snug/search/objective.h"
#include "snug/search/quick_cut.h"
#include "snug/search/searched_zones.h"
#include "snug/search/surface_points.h"
#include "snug/search/turn.h"
#include "snug/space/case_space.h"

namespace snug {
namespace {

constexpr double kFewPoints = 5000, kManyPoints = 40000;
constexpr std::size_t kFirstSpread = 384;  ///< rotations of the first round; each round has twice as many
constexpr std::size_t kMostSpread = 12288;
constexpr std::size_t kTurnsABatch = 64;
constexpr std::size_t kChain = 48;      ///< turns that a coarse climb tries
constexpr std::size_t kFineChain = 48;  ///< and a fine one
constexpr std::size_t kKept = 32;       ///< candidates that are kept from round to round
constexpr std::size_t kDecided = 4;     ///< candidates, and offsets of each, that are looked at exactly
constexpr double kDistinct = 0.99905;   ///< closeness of rotations 5 degrees apart
constexpr double kDiverse = 0.98481;    ///< and 20 degrees apart
constexpr std::size_t kMostDiverse = 12;

struct Candidate {
    Turn turn;
    OffsetCut cut;
    double score = 0;  ///< at most that of the exact placement, but for what points lose to rounding
};

/// The points at one density, and how finely their offsets are looked at.
struct Level {
    SurfacePoints points;
    int fine_y_z = 4, fine_x = 8;
};

}  // namespace

struct PlacementSearch::State {
    const PreparedSurface* surface = nullptr;
    DesignSpace space;
    CutOptions cut;
    std::vector<ItemZone> zones;
    Grid<Run> available;
    std::array<double, 6> least_wall{};
    std::uint64_t seed = 0;
    double longest = 0;
    Level coarse, fine;
    std::optional<Steadiness> steadiness;
    std::optional<Score> score;
    std::optional<BlockSymmetry> symmetry;
    AllowedTurns allowed{std::nullopt};
    std::vector<Turn> first;  ///< rotations that shapes suggest, looked at before all others

    FoundPlacement origin, best;
    long long evaluations = 0;

    std::size_t round = 0;
    std::uint64_t spread = 0;  ///< how many of the sequence were taken
    std::size_t left_in_round = 0;
    std::vector<Candidate> fresh;    ///< of this round, best first
    std::vector<Candidate> waiting;  ///< coarse climbs to do
    std::vector<Candidate> climbed;  ///< fine climbs to do
    std::vector<Candidate> kept;     ///< fine, best first
    std::vector<Candidate> diverse;  ///< the same, further from each other
    std::size_t polish = 0;

    [[nodiscard]] QuickCut kernel(const Level& level) const {
        return QuickCut(space, cut, least_wall, longest, level.fine_y_z, level.fine_x);
    }
    [[nodiscard]] std::vector<Candidate> look(QuickCut& kernel, const Level& level, const Turn& turn,
                                              std::size_t most) const;
    [[nodiscard]] std::optional<Candidate> best_offset(QuickCut& kernel, const Level& level,
                                                       const Turn& turn) const;
    [[nodiscard]] std::optional<PlacementMeasures> exactly(Vec3d rotation_deg, Vec3d offset_mm) const;

    std::vector<Turn> next_spread();
    void spread_step();
    Candidate climb(Candidate from, const Level& level, std::uint64_t stream, std::size_t tries,
                    double widest, double least) const;
    void climb_step(std::vector<Candidate>& from, std::vector<Candidate>& to, const Level& level,
                    std::size_t tries, double widest, double least);
    void keep(std::vector<Candidate>& list, const Candidate& candidate, std::size_t most,
              double distinct = kDistinct) const;
    [[nodiscard]] std::optional<FoundPlacement> decided(const Candidate& candidate, double most) const;
    void decide(const Candidate& candidate);
    void decide_best(const std::vector<Candidate>& list) {
        for (std::size_t i = 0; i < std::min(kDecided, list.size()); ++i) decide(list[i]);
    }
};

using State = PlacementSearch::State;

namespace {

bool better(const Candidate& a, const Candidate& b) {
    return a.score < b.score;
}

}  // namespace

/// The offsets that cut least, with scores that take gap and bearing to be as good as can be.
std::vector<Candidate> State::look(QuickCut& kernel, const Level& level, const Turn& turn,
                                   std::size_t most) const {
    const Rotation rotation = rotation_of(turn);
    const Box3d turned = turned_bounds(surface->body, rotation);
    PlacementMeasures hoped;
    hoped.depth_mm = turned.size().x;
    hoped.bearing = 1;
    hoped.steadiness = steadiness ? (*steadiness)(rotation) : 1;
    std::vector<Candidate> result;
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
    return result;
}

/// The offset of the least score: where gap or bearing are weighed they need the exact kernel.
std::optional<Candidate> State::best_offset(QuickCut& kernel, const Level& level, const Turn& turn) const {
    constexpr std::size_t kMeasured = 3;
    const bool measured = score->weighs(Objective::gap) || score->weighs(Objective::bearing);
    const std::vector<Candidate> offsets = look(kernel, level, turn, measured ? kMeasured : 1);
    if (!measured) return offsets.empty() ? std::optional<Candidate>() : offsets.front();
    std::optional<Candidate> best_one;
    const Vec3d rotation_deg = euler_of(rotation_of(turn));
    for (Candidate offset : offsets) {
        const auto found = exactly(rotation_deg, offset.cut.offset_mm);
        if (!found) continue;
        offset.score = (*score)(*found);
        if (!best_one || better(offset, *best_one)) best_one = offset;
    }
    return best_one;
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
void State::keep(std::vector<Candidate>& list, const Candidate& candidate, std::size_t most,
                 double distinct) const {
    for (Candidate& other : list) {
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
    std::vector<std::optional<Candidate>> found(turns.size());
    parallel_for((turns.size() + kTurnsATask - 1) / kTurnsATask, [&](std::size_t task) {
        QuickCut quick = kernel(coarse);
        for (std::size_t i = task * kTurnsATask; i < std::min(turns.size(), (task + 1) * kTurnsATask); ++i)
            found[i] = best_offset(quick, coarse, turns[i]);
    });
    evaluations += static_cast<long long>(turns.size());
    const std::size_t most = 12 + 6 * round;
    for (const auto& candidate : found)
        if (candidate) keep(fresh, *candidate, most);
}

/// Small turns, ever smaller; each that is no worse is taken.
Candidate State::climb(Candidate from, const Level& level, std::uint64_t stream, std::size_t tries,
                       double widest, double least) const {
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

void State::climb_step(std::vector<Candidate>& from, std::vector<Candidate>& to, const Level& level,
                       std::size_t tries, double widest, double least) {
    constexpr std::size_t kAtOnce = 4;
    const std::size_t count = std::min(kAtOnce, from.size());
    std::vector<Candidate> ends(count);
    parallel_for(count, [&](std::size_t i) {
        const std::uint64_t stream =
            seed * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(evaluations) * 64 + i;
        ends[i] = climb(from[i], level, stream, tries, widest, least);
    });
    from.erase(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(count));
    evaluations += static_cast<long long>(count * (tries + 1));
    for (const Candidate& end : ends) {
        keep(to, end, kKept);
        if (&level == &fine) keep(diverse, end, kMostDiverse, kDiverse);
    }
}

/// The best that the exact kernel finds among a rotation's offsets; none above `most`.
std::optional<FoundPlacement> State::decided(const Candidate& candidate, double most) const {
    std::optional<FoundPlacement> result;
    QuickCut quick = kernel(fine);
    const Vec3d rotation_deg = euler_of(rotation_of(symmetry->least_turned(candidate.turn)));
    for (const Candidate& at : look(quick, fine, turn_of(rotation_from_euler(rotation_deg)), kDecided)) {
        if (at.score > most) break;
        const auto found = exactly(rotation_deg, at.cut.offset_mm);
        if (!found) continue;
        const FoundPlacement next{rotation_deg, at.cut.offset_mm, static_cast<long long>(found->cut_blocks),
                                  (*score)(*found), found->bearing};
        if (next.score <= most && (!result || next < *result)) result = next;
    }
    return result;
}

/// Lets the exact kernel decide where the points do not refuse.
void State::decide(const Candidate& candidate) {
    if (candidate.score > best.score) return;
    ++evaluations;
    const auto found = decided(candidate, best.score);
    if (found && *found < best) best = *found;
}

Result<PlacementSearch> PlacementSearch::start(const Mesh& mesh, const PreparedSurface& surface,
                                               const Design& design, const DesignSpace& space,
                                               std::uint64_t seed, Grid<Run> available,
                                               std::vector<ItemZone> zones) {
    auto state = std::make_unique<State>();
    state->surface = &surface;
    state->space = space;
    state->cut = design.cut;
    state->seed = seed;
    const PlacementOptions& at = design.placement;
    const auto exact = exact_cut(surface, space, design.cut, at.rotation_deg, at.offset_mm, available, zones);
    if (!exact)
        return fail(ErrorKind::does_not_fit,
                    say("search.leaves_space", {{"space", dimensions(space.size())}}));
    const Walls wanted = wanted_wall_mm(design.space);
    bool alike = !design.case_options.inside_mm || !has_shape(design.case_options);
    for (std::size_t side = 0; side < 6; ++side) {
        state->least_wall[side] = std::min(wanted[side], exact->wall_mm[side]);
        alike = alike && (side % 2 == 0 || state->least_wall[side] == state->least_wall[side - 1]);
    }
    state->available = std::move(available);
    state->zones = std::move(zones);
    state->allowed = AllowedTurns(design.search.upright);
    const Rotation stands = rotation_from_euler(at.rotation_deg);
    if (design.search.weight[static_cast<std::size_t>(Objective::flat)] > 0) state->steadiness.emplace(mesh);
    PlacementMeasures measured = measures(*exact, space);
    measured.steadiness = state->steadiness ? (*state->steadiness)(stands) : 1;
    state->score.emplace(design.search.weight, measured);
    // What lies steadily need not do so upside down.
    state->symmetry.emplace(space, alike, !state->allowed.all() || state->steadiness);
    state->evaluations = 1;
    state->origin = state->best = {at.rotation_deg, at.offset_mm, exact->cut_blocks,
                                   (*state->score)(measured), measured.bearing};

    const Vec3d size = bounds(mesh).size();
    state->longest = std::sqrt(dot(size, size));
    const double area = surface_area(mesh);
    const double pitch = std::min({space.block_mm.x, space.block_mm.y, space.block_mm.z});
    state->fine.points = surface_points(mesh, std::max(std::sqrt(area / kManyPoints), pitch / 64));
    state->coarse.points = thinned(state->fine.points, std::sqrt(1.6 * area / kFewPoints));
    state->fine.fine_y_z = 8;
    state->fine.fine_x = 16;
    state->first = suggested_turns(mesh);
    state->first.push_back(turn_of(stands));
    const auto forbidden = [&state](const Turn& turn) { return !state->allowed.allows(turn); };
    state->first.erase(std::remove_if(state->first.begin(), state->first.end(), forbidden),
                       state->first.end());
    state->left_in_round = kFirstSpread;
    return PlacementSearch(std::move(state));
}

void PlacementSearch::step() {
    State& s = *state_;
    if (s.left_in_round > 0) {
        const bool first = s.spread == 0 && s.round == 0;
        s.spread_step();
        // What shapes suggest is often the answer, and early results are worth having.
        if (first || s.left_in_round == 0) s.decide_best(s.fresh);
        if (s.left_in_round > 0) return;
        s.waiting = std::move(s.fresh);
        s.fresh.clear();
    } else if (!s.waiting.empty()) {
        s.climb_step(s.waiting, s.climbed, s.coarse, kChain, 6, 0.5);
        if (s.waiting.empty()) s.climbed.resize(std::min(s.climbed.size(), std::size_t{6} + 2 * s.round));
    } else if (!s.climbed.empty()) {
        s.climb_step(s.climbed, s.kept, s.fine, kFineChain, 1.5, 0.1);
        s.decide_best(s.kept);
    } else if (s.polish < 4 * (s.round + 1)) {
        // The best of all rounds once more, from where they stand; by turns those that lie far apart.
        const std::vector<Candidate>& list = s.polish % 4 == 2 ? s.diverse : s.kept;
        std::vector<Candidate> again(list.begin(),
                                     list.begin() + std::min<std::ptrdiff_t>(4, std::ssize(list)));
        const double widest = s.polish % 2 == 0 ? 2 : 0.3;
        if (!again.empty()) s.climb_step(again, s.kept, s.fine, kFineChain, widest, 0.03);
        s.decide_best(s.kept);
        ++s.polish;
    } else {
        s.polish = 0;
        ++s.round;
        s.left_in_round = std::min(kMostSpread, kFirstSpread << std::min<std::size_t>(s.round, 16));
    }
}

PlacementSearch::PlacementSearch(std::unique_ptr<State> state) : state_(std::move(state)) {}
PlacementSearch::PlacementSearch(PlacementSearch&&) noexcept = default;
PlacementSearch& PlacementSearch::operator=(PlacementSearch&&) noexcept = default;
PlacementSearch::~PlacementSearch() = default;

const FoundPlacement& PlacementSearch::origin() const {
    return state_->origin;
}
const FoundPlacement& PlacementSearch::best() const {
    return state_->best;
}
long long PlacementSearch::evaluations() const {
    return state_->evaluations;
}

std::vector<FoundPlacement> PlacementSearch::distinct(std::size_t most) const {
    std::vector<FoundPlacement> result{best()};
    std::vector<Turn> turns{turn_of(rotation_from_euler(best().rotation_deg))};
    for (const Candidate& candidate : state_->diverse) {
        if (result.size() >= most) break;
        const auto close = [&](const Turn& turn) {
            return state_->symmetry->closest(candidate.turn, turn) >= kDiverse;
        };
        if (std::any_of(turns.begin(), turns.end(), close)) continue;
        const auto found = state_->decided(candidate, std::numeric_limits<double>::infinity());
        if (!found) continue;
        result.push_back(*found);
        turns.push_back(candidate.turn);
    }
    std::stable_sort(result.begin(), result.end());
    return result;
}

bool run(PlacementSearch& search, long long evaluations, const SearchProgress& progress) {
    while (search.evaluations() < evaluations) {
        search.step();
        if (progress && !progress(search)) return false;
    }
    return true;
}

}  // namespace snug
