#pragma once

#include "snug/mesh/read.h"

namespace snug {

/// Whether the file has exactly the size that a binary STL of its triangle count must have.
[[nodiscard]] bool is_whole_binary_stl(Bytes file);

/// Whether the file starts as an ASCII STL does: a line "solid ...", then a line "facet ..." or "endsolid
/// ...".
[[nodiscard]] bool is_ascii_stl(Bytes file);

}  // namespace snug
