#pragma once

#include "snug/base/vec.h"
#include "snug/mesh/mesh.h"

namespace snug::test {

/// The sides of the smallest box around a mesh that CGAL finds.
[[nodiscard]] Vec3d optimal_box(const Mesh& mesh);

}  // namespace snug::test
