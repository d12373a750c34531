#pragma once

#include <vector>

#include "snug/mesh/mesh.h"
#include "snug/search/turn.h"

namespace snug {

/// Rotations that the shape itself suggests, laid along the axes in all six ways: as the file has it, by the
/// principal axes of its surface, and by its largest flat faces, two that stand square to each other at a
/// time. Few, and the same everywhere.
[[nodiscard]] std::vector<Turn> suggested_turns(const Mesh& mesh);

}  // namespace snug
