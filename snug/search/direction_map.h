#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "snug/base/vec.h"
#include "snug/design/design.h"
#include "snug/mesh/mesh.h"
#include "snug/object/prepared_surface.h"
#include "snug/search/exact_cut.h"
#include "snug/search/quick_cut.h"
#include "snug/search/surface_points.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"
#include "snug/space/space_for.h"

namespace snug {

/// One insertion direction and its opposite, which cuts as many blocks.
struct DirectionCut {
    Vec3d
        direction;  ///< of the object's own, of length 1, x not below 0: it lies along +x or -x of the space
    long long cut_blocks = -1;  ///< the least so far over spins and offsets; -1 if none fits yet
    Vec3d rotation_deg;         ///< there; to a thousandth of a degree, as people are shown it
    Vec3d offset_mm;            ///< to a thousandth of a mm
};

/// The cut volume over insertion directions: a map of the half sphere in equal areas, finer in its spins with
/// every pass. Whoever takes one of its placements into the design gets exactly the cut that it names, and
/// the walls that the design wants. The same everywhere and for any number of threads.
class DirectionMap {
  public:
    /// In `space`, or, where the design leaves the number of blocks open, each placement in the space that is
    /// fitted to it. `available`: the blocks that exist in `space`, as exact_cut() has them. `directions`: of
    /// the half sphere; 250 to 1000 make a picture. `surface` is prepared from `mesh` and must outlive the
    /// map; `zones`: as searched_zones() has them.
    DirectionMap(const Mesh& mesh, const PreparedSurface& surface, const Design& design,
                 const DesignSpace& space, std::size_t directions, Grid<Run> available,
                 std::vector<ItemZone> zones = {});

    /// Looks at one more spin of some directions: a few milliseconds of work.
    void step();
    /// Spins of every direction that were looked at.
    [[nodiscard]] std::size_t passes() const { return passes_; }
    [[nodiscard]] const std::vector<DirectionCut>& cuts() const { return cuts_; }

  private:
    void improve(std::size_t direction, const Vec3d& rotation_deg, const std::vector<OffsetCut>& offsets);
    [[nodiscard]] std::optional<ExactCut> exact(Vec3d rotation_deg, Vec3d offset_mm) const;
    [[nodiscard]] Vec3d offset_when_fitted(Vec3d rotation_deg, Vec3d offset_mm) const;
    [[nodiscard]] Result<PackedSpace> fitted_space(Vec3d rotation_deg, Vec3d lies) const;

    const PreparedSurface& surface_;
    Design design_;
    bool fitted_ = false;  ///< every placement has a space of its own
    DesignSpace space_;    ///< of the offsets: the design's, or one that holds the object however it lies
    Grid<Run> available_;  ///< blocks that exist in the design's space
    std::vector<ItemZone> zones_;
    std::array<double, 6> least_wall_{};
    double longest_ = 0;
    SurfacePoints points_;
    std::vector<DirectionCut> cuts_;
    std::vector<long long> promised_;  ///< by the points, of the best so far
    std::size_t passes_ = 0, next_ = 0;
};

}  // namespace snug
