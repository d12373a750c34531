#pragma once

#include "snug/base/result.h"
#include "snug/formats/gltf_json.h"

namespace snug::gltf {

/// Refuses a scene that requires an extension which may concern its geometry and is not known here, by the
/// extension's name. Those about looks alone are passed over.
[[nodiscard]] Result<void> check_extensions(const Json& scene);

}  // namespace snug::gltf
