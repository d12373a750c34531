#pragma once

#include <utility>
#include <vector>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/mesh/mesh.h"
#include "snug/mesh/triangle_tree.h"
#include "snug/space/placement.h"

namespace snug {

/// How far places in the design space lie from an object's surface, for any number of placements.
class SurfaceDistance {
  public:
    /// Fails only when cancelled.
    [[nodiscard]] static Result<SurfaceDistance> build(const Mesh& mesh, const Progress& progress = {});

    /// In mm; `place` in design coordinates. Infinite where the object has no surface.
    [[nodiscard]] double at(Vec3d place, const Placement& placement) const;

  private:
    SurfaceDistance(std::vector<Vec3d> vertices, TriangleTree tree)
        : vertices_(std::move(vertices)), tree_(std::move(tree)) {}

    std::vector<Vec3d> vertices_;  ///< the tree looks at them
    TriangleTree tree_;            ///< in the object's own coordinates
};

}  // namespace snug
