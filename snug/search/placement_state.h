#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "snug/search/objective.h"
#include "snug/search/placement_search.h"
#include "snug/search/quick_cut.h"
#include "snug/search/shock_margins.h"
#include "snug/search/surface_points.h"
#include "snug/search/turn.h"

// What a placement search knows, and each of its steps. For placement_search.cpp alone.

namespace snug {

/// A rotation, and the offset that is best with it.
struct PlacementCandidate {
    Turn turn;
    OffsetCut cut;
    double score = 0;  ///< at most that of the exact placement, but for what points lose to rounding
};

/// Better ones first.
[[nodiscard]] inline bool better(const PlacementCandidate& a, const PlacementCandidate& b) {
    return a.score < b.score;
}

constexpr double kDiverse = 0.98481;  ///< closeness of rotations 20 degrees apart

/// The points at one density, and how finely their offsets are looked at.
struct PointsLevel {
    SurfacePoints points;
    int fine_y_z = 4, fine_x = 8;
};

struct PlacementSearch::State {
    const PreparedSurface* surface = nullptr;
    DesignSpace space;
    CutOptions cut;
    std::vector<ItemZone> zones;
    Grid<Run> available;
    std::array<double, 6> least_wall{};
    std::uint64_t seed = 0;
    double longest = 0;
    PointsLevel coarse, fine;
    std::optional<Steadiness> steadiness;
    std::optional<Score> score;
    // Where shocks are weighed `score` is of estimated margins, that of the full calculation this one:
    std::optional<ShockMargins> shocks;
    std::optional<Score> full_score;
    std::optional<BlockSymmetry> symmetry;
    AllowedTurns allowed{std::nullopt};
    std::vector<Turn> first;  ///< rotations that shapes suggest, looked at before all others

    FoundPlacement origin, best;
    double best_estimate = 0;   ///< `score` of the best
    std::vector<Turn> settled;  ///< where shocks are weighed: of candidates that were decided
    long long evaluations = 0;
    bool finished = false;  ///< no rotation is left

    std::size_t round = 0;
    std::uint64_t spread = 0;  ///< how many of the sequence were taken
    std::size_t left_in_round = 0;
    std::vector<PlacementCandidate> fresh;    ///< of this round, best first
    std::vector<PlacementCandidate> waiting;  ///< coarse climbs to do
    std::vector<PlacementCandidate> climbed;  ///< fine climbs to do
    std::vector<PlacementCandidate> kept;     ///< fine, best first
    std::vector<PlacementCandidate> diverse;  ///< the same, further from each other
    std::size_t polish = 0;

    [[nodiscard]] QuickCut kernel(const PointsLevel& level) const {
        return QuickCut(space, cut, least_wall, longest, level.fine_y_z, level.fine_x);
    }
    [[nodiscard]] std::vector<PlacementCandidate> look(QuickCut& kernel, const PointsLevel& level,
                                                       const Turn& turn, std::size_t most) const;
    [[nodiscard]] std::optional<PlacementCandidate> best_offset(QuickCut& kernel, const PointsLevel& level,
                                                                const Turn& turn) const;
    [[nodiscard]] std::optional<PlacementMeasures> exactly(Vec3d rotation_deg, Vec3d offset_mm) const;
    /// A placement that the exact kernel looked at.
    struct Looked {
        FoundPlacement found;  ///< with `score`
        PlacementMeasures measured;
    };
    [[nodiscard]] std::optional<Looked> looked_at(Vec3d rotation_deg, Vec3d offset_mm) const;
    [[nodiscard]] Looked shifted(Looked from) const;
    [[nodiscard]] std::optional<FoundPlacement> in_full(const Looked& looked) const;
    /// Offsets of a rotation that are looked at exactly where measures need that, or where it is decided.
    [[nodiscard]] std::size_t most_offsets(std::size_t usual) const {
        constexpr std::size_t kOfOneTurn = 64;
        return allowed.only_one() ? kOfOneTurn : usual;
    }

    [[nodiscard]] long long cost_of(std::size_t rotations) const;

    std::vector<Turn> next_spread();
    void spread_step();
    PlacementCandidate climb(PlacementCandidate from, const PointsLevel& level, std::uint64_t stream,
                             std::size_t tries, double widest, double least) const;
    void climb_step(std::vector<PlacementCandidate>& from, std::vector<PlacementCandidate>& to,
                    const PointsLevel& level, std::size_t tries, double widest, double least);
    void keep(std::vector<PlacementCandidate>& list, const PlacementCandidate& candidate, std::size_t most,
              double distinct) const;
    [[nodiscard]] std::vector<Looked> decided(const PlacementCandidate& candidate, double most) const;
    void decide(const PlacementCandidate& candidate);
    void decide_in_full(const PlacementCandidate& candidate);
    void decide_best(const std::vector<PlacementCandidate>& list);
};

}  // namespace snug
