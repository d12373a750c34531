#pragma once

#include <array>
#include <cstddef>

#include "snug/depth/depth_map.h"
#include "snug/object/prepared_surface.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

namespace snug {

/// What some neighbouring boxes of a level may reach once they are placed: their lowest and highest x in
/// design coordinates (mm), and their columns, rows first_j..last_j and first_k..last_k; empty (first > last)
/// where they miss the space.
struct BoxReaches {
    using Cells = std::array<int, BoxGroup::kBoxes>;
    BoxGroup::Lanes lowest, highest;
    Cells first_j, last_j, first_k, last_k;
};

/// Places boxes in float arithmetic, and grows them by more than its errors: whatever the surface within a
/// box adds to a depth map lies within its reach, with the rounding of crossings.
class BoxPlacer {
  public:
    BoxPlacer(const SurfaceClusters& surface, const Placement& placement, const DesignSpace& space,
              Reach reach);

    [[nodiscard]] BoxReaches operator()(const BoxGroup& group) const;

    /// More than the errors of float arithmetic and of crossings, mm.
    [[nodiscard]] double slack() const { return slack_; }

  private:
    std::array<std::array<float, 3>, 3> row_;  ///< of the rotation; y and z in cells instead of mm
    std::array<float, 3> shift_;
    std::array<float, 3> grow_;
    std::array<float, 3> cells_;
    float slack_;
};

}  // namespace snug
