#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/design/design.h"
#include "snug/foam/foams.h"
#include "snug/mesh/mesh.h"
#include "snug/object/prepared_surface.h"
#include "snug/search/shock_margins.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"

// Search over everything that changes the foam: all rotations, less those that the blocks' symmetry makes
// equal, and the offset within half a block of the centre. Coarse to fine: points of the surface, for a
// lattice of offsets at a time, refuse most (quick_cut.h); the exact kernel decides among the rest. Where
// shocks are weighed an estimate refuses too (shock_estimate.h), whole blocks are looked at besides half of
// one, and what is met in a drop decides by the full calculation.

namespace snug {

/// A placement that was looked at exactly.
struct FoundPlacement {
    Vec3d rotation_deg;
    Vec3d offset_mm;
    long long cut_blocks = 0;
    double score = 0;    ///< by the design's objectives (objective.h), shocks in full; less is better
    double bearing = 0;  ///< PlacementMeasures::bearing

    /// Better: a smaller score, and of equal ones more bearing.
    friend bool operator<(const FoundPlacement& a, const FoundPlacement& b) {
        return a.score != b.score ? a.score < b.score : a.bearing > b.bearing;
    }
};

/// A search without an end: each step leaves the best placement so far, which is never worse than the start.
/// The same for the same seed on any number of threads.
class PlacementSearch {
  public:
    /// Stands at the design's placement. `space` is that of the packing there; `surface` is prepared from
    /// `mesh`, and must outlive the search; `zones`: as searched_zones() has them. Fails (kind does_not_fit)
    /// where the object, grown by its clearance, or what its zones keep free leaves the space already, or
    /// the blocks that exist in it. `shocks`: where they are weighed, from the same placement.
    [[nodiscard]] static Result<PlacementSearch> start(const Mesh& mesh, const PreparedSurface& surface,
                                                       const Design& design, const DesignSpace& space,
                                                       std::uint64_t seed, Grid<Run> available,
                                                       std::vector<ItemZone> zones = {},
                                                       std::optional<ShockMargins> shocks = {});
    PlacementSearch(PlacementSearch&&) noexcept;
    PlacementSearch& operator=(PlacementSearch&&) noexcept;
    ~PlacementSearch();

    /// Looks at some more rotations: a few milliseconds of work.
    void step();

    [[nodiscard]] const FoundPlacement& origin() const;  ///< where it started
    [[nodiscard]] const FoundPlacement& best() const;
    /// The best of at most `most` placements that differ by more than 20 degrees, whatever symmetry makes
    /// equal; best() first. What else there is than the best number, which may be a silly way to lie.
    [[nodiscard]] std::vector<FoundPlacement> distinct(std::size_t most = 6) const;
    /// Rotations looked at, each at many offsets, and placements looked at exactly, the start included; where
    /// shocks are weighed each for as many as could be looked at in its time.
    [[nodiscard]] long long evaluations() const;
    /// Nothing is left to look at, since the object may not be turned at all.
    [[nodiscard]] bool finished() const;

    struct State;  ///< opaque

  private:
    explicit PlacementSearch(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Is told after each step; false cancels.
using SearchProgress = std::function<bool(const PlacementSearch&)>;

constexpr long long kSearchEvaluations = 20000;  ///< some seconds on one core

/// Steps until as many evaluations are done, it is finished or `progress` cancels. False if it was cancelled.
bool run(PlacementSearch& search, long long evaluations, const SearchProgress& progress = {});

}  // namespace snug
