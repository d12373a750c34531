#pragma once

#include <string>
#include <vector>

#include "bench/objects.h"

namespace snug::bench {

/// Every shared model and every sample, of a diagonal of kDiagonal, refined as far as 100,000 triangles
/// allow.
[[nodiscard]] std::vector<NamedMesh> search_objects();

}  // namespace snug::bench
