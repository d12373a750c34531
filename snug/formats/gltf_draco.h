#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "snug/base/result.h"
#include "snug/formats/gltf_accessor.h"
#include "snug/formats/gltf_buffers.h"
#include "snug/formats/scene_tools.h"

namespace snug::gltf {

/// Refuses what is no packed mesh, or claims more triangles than its bytes can hold, before a decoder is
/// asked.
[[nodiscard]] Result<void> check_draco(Bytes packed);

/// The meshes of a scene that KHR_draco_mesh_compression packs; each is unpacked once.
class DracoMeshes {
  public:
    explicit DracoMeshes(const SceneTools& tools) : tools_(tools) {}

    /// Every corner is a point that is there, every attribute has a value of each point. The mesh lives as
    /// long as this.
    [[nodiscard]] Result<const DracoMesh*> open(Buffers& buffers, std::uint64_t view,
                                                const std::vector<DracoAttribute>& attributes);

  private:
    const SceneTools& tools_;
    std::map<std::vector<std::uint64_t>, DracoMesh> known_;
};

}  // namespace snug::gltf
