#pragma once

#include "snug/base/bytes.h"
#include "snug/base/result.h"
#include "snug/formats/gltf_json.h"
#include "snug/formats/scene_tools.h"

namespace snug::gltf {

/// Unpacks a buffer view by its EXT_meshopt_compression object: sizes and the codec's version are checked
/// first, the filter is undone afterwards, with the same bits everywhere. Newer codecs are refused by name.
[[nodiscard]] Result<FileBytes> unpack_meshopt(Bytes packed, const Json& extension, const SceneTools& tools);

}  // namespace snug::gltf
