#pragma once

#include "snug/base/bytes.h"
#include "snug/base/result.h"
#include "snug/formats/scene_tools.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// Whether the zip is a 3MF: one whose relationships name a model.
[[nodiscard]] bool is_3mf(Bytes file, const SceneTools& tools);

/// The mesh of a 3MF file in mm: everything that its build places, where it places it, from all of its parts.
/// Supports count only where nothing else is placed, objects of type "other" never. A model whose build is
/// empty is taken if it has one object alone. Triangles with corners that are not there or no numbers are
/// left out and counted (Mesh::read); the file is refused where they are more than half. Needs `inflate` of
/// the tools. Errors of kind `input`, without the file's name.
[[nodiscard]] Result<Mesh> read_3mf(Bytes file, const SceneTools& tools);

}  // namespace snug
