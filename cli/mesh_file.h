#pragma once

#include <string>
#include <string_view>

#include "snug/base/bytes.h"
#include "snug/mesh/mesh.h"
#include "snug/words/words.h"

namespace snug::cli {

/// Writes a mesh, in millimetres, in the format that the file's name ends with (STL, PLY, OBJ, OFF), and says
/// so. `title`: what an STL begins with. Gives the exit status.
[[nodiscard]] int write_mesh_file(const Mesh& mesh, const std::string& file, std::string_view title,
                                  Language language);

}  // namespace snug::cli
