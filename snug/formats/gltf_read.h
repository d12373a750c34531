#pragma once

#include "snug/base/bytes.h"
#include "snug/base/result.h"
#include "snug/formats/scene_tools.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// glTF 2.0, as .glb or .gltf: every triangle that a viewer shows when it opens the file, where it shows it,
/// in mm (Mesh::read.in_mm): the default scene, its nodes and their repetitions, default morph weights,
/// skeletons without movement; quantised, sparse and packed positions. Points alone are a cloud. Looks, light
/// and movement are passed over. Errors of kind `input`. Hostile bytes take memory and time in proportion to
/// the file.
[[nodiscard]] Result<Mesh> read_gltf(Bytes file, const SceneTools& tools);

}  // namespace snug
