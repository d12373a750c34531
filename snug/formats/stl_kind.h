#pragma once

#include <cstddef>

#include "snug/formats/read.h"

namespace snug {

/// Whether the file has exactly the size that a binary STL of its triangle count must have.
[[nodiscard]] bool is_whole_binary_stl(Bytes file);

/// Bytes at the beginning of a file that tell whether it is an ASCII STL.
inline constexpr std::size_t kStlKindBytes = 1 << 16;
/// Whether the file begins as an ASCII STL does: "solid ..." or, behind comments or without a solid, a facet;
/// and within those bytes a facet begins or a solid ends.
[[nodiscard]] bool is_ascii_stl(Bytes file);

/// By words, whatever stands in one line; comments, colours and names of any kind are passed over. A facet
/// that is no triangle is left out and counted. A missing "endsolid" is noted; a facet that is cut off is
/// refused.
[[nodiscard]] Result<Mesh> read_ascii_stl(Bytes file);

}  // namespace snug
