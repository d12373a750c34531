#pragma once

#include <cstddef>
#include <vector>

#include "snug/base/box.h"
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

    /// What the points span once they are turned: never longer than the object.
    [[nodiscard]] Box3d turned(const Rotation& rotation) const;
    /// Its lengths along the axes.
    [[nodiscard]] Vec3d lengths(const Rotation& rotation) const { return turned(rotation).size(); }
    /// Adds those that lie furthest out once they are turned, by a pass over all vertices: then turned() is
    /// the object's own box.
    void add_furthest(const Rotation& rotation);
    [[nodiscard]] std::vector<Vec3d> points() const;

  private:
    void add(Vec3d direction);

    const Mesh& mesh_;
    std::vector<std::size_t> known_;  ///< indices of vertices, sorted
    std::vector<double> x_, y_, z_;
};

}  // namespace snug
