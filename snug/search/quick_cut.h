#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "snug/base/box.h"
#include "snug/base/rotation.h"
#include "snug/design/design.h"
#include "snug/search/surface_points.h"
#include "snug/space/design_space.h"

namespace snug {

/// How many blocks points cut at one offset.
struct OffsetCut {
    long long blocks = 0;
    Vec3d offset_mm;  ///< within half a block of the centre on each axis
};

/// Counts the blocks that points of a surface cut, for one rotation and a whole lattice of offsets at a time:
/// the points fill one depth map of finer columns, and what a column of blocks meets is the extreme over a
/// window of fine ones, wherever the blocks begin. As the points are only some of the surface, the counts are
/// (up to the rounding of a clearance to fine columns) below those of the surface: what they refuse need not
/// be looked at exactly.
class QuickCut {
  public:
    /// `least_wall`: mm on each side, as in Climb. `longest`: no turned object is longer along any axis, mm.
    /// `fine_y_z` offsets a block along y and z, `fine_x` along x; powers of two, at most 8 and 32.
    QuickCut(const DesignSpace& space, const CutOptions& cut, const std::array<double, 6>& least_wall,
             double longest, int fine_y_z, int fine_x);

    /// The offsets that cut the fewest blocks, best first, at most `most`; of equals the first of the
    /// lattice. None where no offset keeps the walls. `turned`: the bounding box of the turned surface;
    /// `kept_free`: what its zones keep free there, whose blocks are not counted; empty: nothing.
    [[nodiscard]] std::vector<OffsetCut> least(const SurfacePoints& points, const Rotation& rotation,
                                               const Box3d& turned, std::size_t most,
                                               const Box3d& kept_free = {});

  private:
    static constexpr int kLanes = 8;
    using Lanes [[gnu::vector_size(16)]] = std::int16_t;

    /// Blocks along one axis and the lattice on them.
    struct Axis {
        double block;   ///< of the lattice: the design's, or a multiple where those are very small
        int fine;       ///< offsets a block
        double pitch;   ///< block / fine
        int reach;      ///< twice the clearance in pitches
        int window;     ///< fine columns that one column of blocks meets
        int cells = 0;  ///< fine columns of the object, without those that only windows reach
    };

    void size_grid(Vec3d extent);
    void bin(const SurfacePoints& points, const Rotation& rotation, Vec3d low);
    void slide_along_z();
    void slide_along_y();
    void count();
    [[nodiscard]] double offset(int axis, int phase, double extent) const;
    [[nodiscard]] bool keeps_walls(int axis, double offset, const Box3d& room) const;
    [[nodiscard]] std::size_t slot(int px, int py, int pz) const {
        return static_cast<std::size_t>((py * axes_[0].fine + px) * axes_[2].fine + pz);
    }

    DesignSpace space_;
    Vec3d grown_below_, grown_above_;  ///< by the clearance, on each side
    Vec3d inset_;                      ///< of it, so that faces on faces cut nothing
    std::array<double, 6> least_wall_;
    std::array<Axis, 3> axes_;
    int rows_ = 0, vectors_ = 0;  ///< of the fine depth map with its margins: a row has whole vectors
    std::vector<Lanes> low_, high_, low_slid_, high_slid_;
    std::vector<long long> counts_;
};

}  // namespace snug
