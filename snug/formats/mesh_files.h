#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "snug/base/bytes.h"
#include "snug/base/color.h"
#include "snug/base/vec.h"

namespace snug {

/// Binary STL: an 80-byte header that starts with `title` ("binary " before a title that would make it look
/// like a text STL), facet normals from the vertices; no units, no colour.
[[nodiscard]] FileBytes write_stl(std::span<const Vec3f> vertices, std::span<const Triangle> triangles,
                                  std::string_view title);

/// Binary little-endian PLY: float x, y, z (and uchar red, green, blue where a colour is given), faces as
/// vertex_indices.
[[nodiscard]] FileBytes write_ply(std::span<const Vec3f> vertices, std::span<const Triangle> triangles,
                                  std::optional<Color> color);

/// Wavefront OBJ and OFF as text, with the shortest digits that read back as the same floats.
[[nodiscard]] FileBytes write_obj(std::span<const Vec3f> vertices, std::span<const Triangle> triangles);
[[nodiscard]] FileBytes write_off(std::span<const Vec3f> vertices, std::span<const Triangle> triangles);

}  // namespace snug
