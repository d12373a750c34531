#pragma once

#include <cstddef>
#include <vector>

#include "snug/base/rotation.h"
#include "snug/base/vec.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// Vertices that lie furthest out in some direction: few, and enough to know how long the object is along
/// turned axes, nearly always. Where they were not enough, more are added.
class ExtremePoints {
  public:
    /// The furthest vertices in some hundred directions.
    explicit ExtremePoints(const Mesh& mesh);

    /// Lengths along the axes of what the points span once they are turned: never longer than the object.
    [[nodiscard]] Vec3d lengths(const Rotation& rotation) const;
    /// The object's own lengths, by a pass over all vertices, whose furthest are added.
    Vec3d add_furthest(const Rotation& rotation);
    [[nodiscard]] std::vector<Vec3d> points() const;

  private:
    void add(Vec3d direction);

    const Mesh& mesh_;
    std::vector<std::size_t> known_;  ///< indices of vertices, sorted
    std::vector<double> x_, y_, z_;
};

}  // namespace snug
