#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "snug/base/vec.h"
#include "snug/design/design.h"
#include "snug/foam/design_space.h"
#include "snug/foam/prepared_surface.h"
#include "snug/mesh/mesh.h"
#include "snug/search/surface_points.h"

namespace snug {

/// One insertion direction and its opposite, which cuts as many blocks.
struct DirectionCut {
    Vec3d
        direction;  ///< of the object's own, of length 1, x not below 0: it lies along +x or -x of the space
    long long cut_blocks = -1;  ///< the least so far over spins and offsets, from points; -1 if none fits yet
    Vec3d rotation_deg;         ///< there
    Vec3d offset_mm;
};

/// The cut volume over insertion directions: a map of the half sphere in equal areas, finer in its spins with
/// every pass. The same everywhere and for any number of threads.
class DirectionMap {
  public:
    /// Keeps the wanted walls. `directions`: of the half sphere; 250 to 1000 make a picture. `surface` is
    /// prepared from `mesh` and must outlive the map.
    DirectionMap(const Mesh& mesh, const PreparedSurface& surface, const Design& design,
                 const DesignSpace& space, std::size_t directions = 500);

    /// Looks at one more spin of some directions: a few milliseconds of work.
    void step();
    /// Spins of every direction that were looked at.
    [[nodiscard]] std::size_t passes() const { return passes_; }
    [[nodiscard]] const std::vector<DirectionCut>& cuts() const { return cuts_; }

  private:
    const PreparedSurface& surface_;
    DesignSpace space_;
    CutOptions cut_;
    std::array<double, 6> least_wall_{};
    double longest_ = 0;
    SurfacePoints points_;
    std::vector<DirectionCut> cuts_;
    std::size_t passes_ = 0, next_ = 0;
};

}  // namespace snug
