#pragma once

#include <span>

#include "snug/base/bytes.h"
#include "snug/base/result.h"
#include "snug/formats/scene_tools.h"

namespace snug::cli {

/// SceneTools::draco by libdraco, which nobody proves safe on bytes that were made to hurt: in a process of
/// its own, whose time and memory are bounded, so that such bytes are only a file that cannot be read.
[[nodiscard]] Result<DracoMesh> unpack_draco_in_a_process(Bytes packed,
                                                          std::span<const DracoAttribute> attributes);

}  // namespace snug::cli
