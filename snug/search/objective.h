#pragma once

#include <array>
#include <vector>

#include "snug/base/rotation.h"
#include "snug/base/vec.h"
#include "snug/design/search_options.h"
#include "snug/mesh/mesh.h"
#include "snug/search/exact_cut.h"
#include "snug/space/design_space.h"

namespace snug {

/// What objectives are about, for one placement.
struct PlacementMeasures {
    double cut_blocks = 0;
    double gap_mm = 0;      ///< between surface and foam along x: mean over both ends of the touched columns
    double depth_mm = 0;    ///< that the cut is deep, from the lowest block to the highest
    double bearing = 0;     ///< share of those ends that lie within 3 mm of the foam
    double steadiness = 0;  ///< sine of the angle at which the object lying there tips over; below 0 it falls
    std::array<double, 6> margins{};  ///< what is met on each side for what it bears, as Protection has it
};

/// All but the steadiness and the margins.
[[nodiscard]] PlacementMeasures measures(const ExactCut& exact, const DesignSpace& space);

/// How steadily an object stands on a plane across x. Its weight is taken to lie at the centre of its
/// surface.
class Steadiness {
  public:
    explicit Steadiness(const Mesh& mesh);
    [[nodiscard]] double operator()(const Rotation& rotation) const;

  private:
    std::vector<Vec3d> outermost_;
    Vec3d weight_;
    double touching_ = 0;  ///< mm above the lowest point that count as touching the plane
};

/// Weighs measures against those of the start: cut, gap, depth and the worst margin as shares of the start's,
/// bearing and steadiness as what is missing from 1. Less is better.
class Score {
  public:
    Score(const std::array<double, kObjectives>& weight, const PlacementMeasures& start);

    [[nodiscard]] bool weighs(Objective objective) const {
        return weight_[static_cast<std::size_t>(objective)] > 0;
    }
    [[nodiscard]] double operator()(const PlacementMeasures& at) const;

  private:
    std::array<double, kObjectives> weight_;
    PlacementMeasures start_;
};

}  // namespace snug
