#include "snug/search/placement_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "snug/base/text.h"
#include "snug/search/exact_cut.h"
#include "snug/search/frames.h"
#include "snug/search/placement_state.h"
#include "snug/space/case_space.h"

namespace snug {
namespace {

constexpr double kFewPoints = 5000, kManyPoints = 40000;
constexpr std::size_t kFirstSpread = 384;  ///< rotations of the first round; each round has twice as many
constexpr std::size_t kMostSpread = 12288;
constexpr std::size_t kChain = 48;      ///< turns that a coarse climb tries
constexpr std::size_t kFineChain = 48;  ///< and a fine one

}  // namespace

using State = PlacementSearch::State;

Result<PlacementSearch> PlacementSearch::start(const Mesh& mesh, const PreparedSurface& surface,
                                               const Design& design, const DesignSpace& space,
                                               std::uint64_t seed, Grid<Run> available,
                                               std::vector<ItemZone> zones,
                                               std::optional<ShockMargins> shocks) {
    assert(shocks || !design.search.weighs(Objective::shock));
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
    state->allowed = allowed_turns(design.search, at.rotation_deg);
    const Rotation stands = rotation_from_euler(at.rotation_deg);
    if (design.search.weighs(Objective::flat)) state->steadiness.emplace(mesh);
    PlacementMeasures measured = measures(*exact, space);
    measured.steadiness = state->steadiness ? (*state->steadiness)(stands) : 1;
    PlacementMeasures in_full = measured;
    if (shocks) {
        in_full.margins = shocks->at_start();
        measured.margins = shocks->estimated(*exact);
    }
    state->score.emplace(design.search.weight, measured);
    state->full_score.emplace(design.search.weight, in_full);
    // What lies steadily need not do so upside down; and only so many ways to lie may be allowed.
    state->symmetry.emplace(space, alike && !shocks, !state->allowed.all() || state->steadiness);
    state->evaluations = 1;
    state->origin = state->best = {at.rotation_deg, at.offset_mm, exact->cut_blocks,
                                   (*state->full_score)(in_full), measured.bearing};
    state->best_estimate = (*state->score)(measured);
    state->shocks = std::move(shocks);

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
    if (s.finished) return;
    if (s.left_in_round > 0) {
        const bool first = s.spread == 0 && s.round == 0;
        s.spread_step();
        // What shapes suggest is often the answer, and early results are worth having.
        if (first || s.left_in_round == 0) s.decide_best(s.fresh);
        s.finished = s.allowed.only_one();
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
        const std::vector<PlacementCandidate>& list = s.polish % 4 == 2 ? s.diverse : s.kept;
        std::vector<PlacementCandidate> again(list.begin(),
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
bool PlacementSearch::finished() const {
    return state_->finished;
}

std::vector<FoundPlacement> PlacementSearch::distinct(std::size_t most) const {
    std::vector<FoundPlacement> result{best()};
    std::vector<Turn> turns{turn_of(rotation_from_euler(best().rotation_deg))};
    for (const PlacementCandidate& candidate : state_->diverse) {
        if (result.size() >= most) break;
        const auto close = [&](const Turn& turn) {
            return state_->symmetry->closest(candidate.turn, turn) >= kDiverse;
        };
        if (std::any_of(turns.begin(), turns.end(), close)) continue;
        const auto looked = state_->decided(candidate, std::numeric_limits<double>::infinity());
        if (looked.empty()) continue;
        const auto found = state_->shocks ? state_->in_full(looked.front()) : looked.front().found;
        if (!found) continue;
        result.push_back(*found);
        turns.push_back(candidate.turn);
    }
    std::stable_sort(result.begin(), result.end());
    return result;
}

bool run(PlacementSearch& search, long long evaluations, const SearchProgress& progress) {
    while (search.evaluations() < evaluations && !search.finished()) {
        search.step();
        if (progress && !progress(search)) return false;
    }
    return true;
}

}  // namespace snug
