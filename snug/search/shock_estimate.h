#pragma once

#include <array>
#include <vector>

#include "snug/base/vec.h"
#include "snug/check/face_shocks.h"
#include "snug/check/packing.h"
#include "snug/mesh/mesh.h"
#include "snug/search/exact_cut.h"
#include "snug/search/shock_wishes.h"
#include "snug/search/surface_points.h"

namespace snug {

/// What protection() would tell of one object in another place, in about a millisecond (some where there are
/// ten thousand columns of blocks): good for putting placements in order and for refusing them, and never
/// told to people. The foam is that of the exact cut, and its columns are pressed as there; but
///   - the object's ends along each axis are those of some thousand points of its surface, on some hundred
///     lines, each for the outermost points in a square of its own that counts half at the object's rim, in
///     place of 64 lines a column of blocks that meet every triangle;
///   - of the curves that the foam may have those at both ends count, and the fall is 15 % higher;
///   - the surface of zones counts as the rest does;
///   - notches, ribs and slots for lifting are not cut, and the height by a rule is that of the start.
/// How the mass is spread is taken over from the start. Where both tell of a G the margin is 0.75 to 1.5
/// times that of the full calculation, as tests have it; where the foam nearly bottoms it may be on the other
/// side.
class ShockEstimate {
  public:
    /// `start`: of one object, with foams. `mesh`: its own or its stand-in's.
    ShockEstimate(const Mesh& mesh, const PackedShocks& start, const AxisLines& lines);

    /// The margin on each side, as Protection::margins() has it.
    [[nodiscard]] std::array<double, 6> operator()(const ExactCut& exact) const;

  private:
    [[nodiscard]] AxisLines lines(const std::vector<Vec3d>& placed, const Placement& placement,
                                  int axis) const;
    [[nodiscard]] MassSpread spread(const Placement& placement) const;

    SurfacePoints points_;
    double square_mm_ = 0;  ///< that a line stands for, along its sides
    Packing packing_;       ///< of the start: what stays the same
    Protection known_;
    Curves curves_;
    Placement start_;
    MassSpread spread_;  ///< of the start
    Vec3d centre_;       ///< of mass, in the object's coordinates
};

}  // namespace snug
