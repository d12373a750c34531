#pragma once

#include <optional>
#include <vector>

#include "snug/base/grid.h"
#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/check/largest_ball.h"
#include "snug/check/line_budget.h"
#include "snug/foam/block_map.h"
#include "snug/mesh/mesh.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

namespace snug {

/// Of the gap, what one half's foam faces: on a line that meets the object all below its first hit is the
/// lower half's and all above its last the upper's; between them, and on other lines, the parting level
/// divides.
struct HalfGap {
    double step_mm3 = 0;
    std::optional<double> undercut_mm3;  ///< none unless the object is closed
    double widest_mm = 0;  ///< as in GapFigures, of balls on the half's side of the parting level
    double widest_error_mm = 0;
    Vec3d widest_at;
};

/// Mean depths of the gap over a column, mm: a map to look at.
struct ColumnGap {
    float lower_step = 0, lower_undercut = 0;
    float upper_step = 0, upper_undercut = 0;
    friend bool operator==(const ColumnGap&, const ColumnGap&) = default;
};

/// The cut-away space that the object does not fill, sampled on lines along x (LineLattice).
///   hull      what lies between the first and last hit of each line
///   solid     where the winding number is not 0
///   step      cut - hull: what the blocks' size costs
///   undercut  hull - solid: what the height fields cost
/// hull and solid are those of the whole object, step and undercut lie within the cut. So where the object
/// sticks out of the cut (a negative clearance squeezes it in), step is more than the difference of the
/// volumes.
struct GapFigures {
    /// 256: 16 x 16. Fewer where that would be too much work (LineBudget), 1/4 where one line stands for 2 x
    /// 2 columns, and so on; the error tells what that costs.
    double lines_per_column = 0;
    double cut_mm3 = 0;  ///< exact
    double hull_mm3 = 0;
    std::optional<double> solid_mm3;  ///< none unless the object is closed
    double step_mm3 = 0;
    std::optional<double> undercut_mm3;  ///< none unless the object is closed
    double error_mm3 = 0;        ///< of the sampled volumes: two standard errors, estimated from how 16
                                 ///< interleaved sixteenths of the lines differ, of the worst of them
    double widest_mm = 0;        ///< diameter of the largest ball in the gap (outside the hull where solid
                                 ///< is unknown; there the hull is taken as its lines see it)
    double widest_error_mm = 0;  ///< the true diameter is at most this much larger
    Vec3d widest_at;             ///< that ball's centre, in design coordinates; no place if widest_mm is 0
    HalfGap lower, upper;        ///< their steps and undercuts add up to the whole
};

/// Of one layer: the same, and where it is.
struct GapReport : GapFigures {
    Grid<ColumnGap> columns;  ///< undercuts are 0 unless the object is closed
};

/// Of layers that stand on each other, one at least: their volumes and errors together, and the widest ball.
[[nodiscard]] GapFigures united(const std::vector<GapReport>& layers);

/// What a report may cost.
struct GapLimits {
    LineBudget lines;
    LargestBallOptions ball;  ///< of each of the three
};

/// `closed` is MeshMeasure::watertight. Fails only when cancelled.
[[nodiscard]] Result<GapReport> gap_report(const Mesh& mesh, const Placement& placement,
                                           const DesignSpace& space, const BlockMap& blocks,
                                           int parting_level, bool closed, const Progress& progress = {},
                                           const GapLimits& limits = {});

}  // namespace snug
