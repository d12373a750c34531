#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "snug/depth/cells.h"
#include "snug/depth/depth_builder.h"
#include "snug/mesh/mesh.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

namespace snug {

/// Says of one part of a mesh after the other whether it cuts any block by itself: the same answer as a depth
/// map and block map of the part alone, at the cost of the columns around the part, and of few of them where
/// the answer is yes.
class PartCut {
  public:
    /// Looks at lines of columns for all parts together: some seconds' work at the most.
    static constexpr long long kMostWork = 1LL << 26;

    PartCut(const Placement& placement, const DesignSpace& space, Reach reach);

    /// `triangles`: indices into the mesh's. None where it would take more than is left of kMostWork.
    [[nodiscard]] std::optional<bool> cuts(const Mesh& mesh, std::span<const std::uint32_t> triangles);
    /// A part that is a mesh of its own.
    [[nodiscard]] std::optional<bool> cuts(const Mesh& part);

  private:
    struct Placed {
        std::array<Vec3d, 3> corners;
        ColumnBlock met;
    };

    [[nodiscard]] bool reaches_block(double lowest, double highest) const;
    void add(const Placed& triangle, CellRange rows);
    /// Whether any column of the block is cut; empties them all.
    bool take_cut(const ColumnBlock& block);

    const Placement& placement_;
    Reach reach_;
    GrownCells along_x_;
    DepthMapBuilder builder_;  ///< empty between parts
    long long work_ = 0;
};

}  // namespace snug
