#pragma once

#include "snug/mesh/mesh.h"

#include "tests/support/random.h"

namespace snug::test {

[[nodiscard]] Vec3d random_direction(Random& random);

/// A cloud on a mesh: no place of the surface is further than spacing / sqrt(3) from a point, and no point
/// nearer than half of that to another, however fine the mesh; then each point is moved by at most `noise`.
[[nodiscard]] Mesh sampled(const Mesh& mesh, double spacing, double noise);

/// The cloud as a scanner sees it that cannot look at one end along an axis: a share of its length is left
/// out there.
[[nodiscard]] Mesh without_end(const Mesh& cloud, int axis, double share, bool low);

}  // namespace snug::test
