#pragma once

#include <string_view>

#include "snug/base/bytes.h"
#include "snug/base/result.h"
#include "snug/formats/scene_tools.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// Whatever a file holds that Snug can pack: a scene, whose lengths come in mm (Mesh::read.in_mm), a mesh or
/// a cloud. The format is told by the content, then by the name's ending. Errors of kind `input`, without the
/// file's name.
[[nodiscard]] Result<Mesh> read_object(Bytes file, std::string_view name, const SceneTools& tools);

}  // namespace snug
