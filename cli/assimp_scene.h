#pragma once

#include <filesystem>
#include <string>

#include "snug/base/result.h"
#include "snug/mesh/mesh.h"
#include "snug/mesh/read.h"

namespace snug::cli {

enum class SceneFormat { glb, gltf, threemf };

/// All triangles of a scene, where its nodes place them, in mm; each mesh as often as it is placed. Buffers
/// of their own are read only from the scene's folder. Errors of kind `input` say what is wrong, without the
/// file's name.
///
/// By assimp, whose readers are known to fall over bytes that were made to hurt: call it in a process of its
/// own (scene_file.h).
[[nodiscard]] Result<Mesh> read_scene_here(Bytes file, SceneFormat format, const std::filesystem::path& path);

}  // namespace snug::cli
