#pragma once

#include "snug/mesh/mesh.h"

namespace snug::bench {

/// Each triangle cut into four at the midpoints of its edges, shared between neighbours.
[[nodiscard]] Mesh refined(const Mesh& mesh);

}  // namespace snug::bench
