#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "snug/base/result.h"
#include "snug/formats/gltf_accessor.h"
#include "snug/formats/gltf_buffers.h"
#include "snug/formats/gltf_json.h"
#include "snug/formats/scene_tools.h"

namespace snug::gltf {

/// Refuses what is no packed mesh, or claims more triangles than its bytes can hold, before a decoder is
/// asked.
[[nodiscard]] Result<void> check_draco(Bytes packed);

/// The meshes of a scene that KHR_draco_mesh_compression packs; each is unpacked once.
class DracoMeshes {
  public:
    static constexpr const char* kExtension = "KHR_draco_mesh_compression";

    DracoMeshes(const Json& scene, const SceneTools& tools)
        : tools_(tools), required_(names(field(scene, "extensionsRequired"), kExtension)) {}

    /// Whether the scene has nothing to fall back to.
    [[nodiscard]] bool required() const { return required_; }
    /// Whether any was unpacked.
    [[nodiscard]] bool used() const { return !known_.empty(); }
    /// Every corner is a point that is there, every attribute has a value of each point. The mesh lives as
    /// long as this. Once the decoder failed it is not asked again: it may take long for that.
    [[nodiscard]] Result<const DracoMesh*> open(Buffers& buffers, std::uint64_t view,
                                                const std::vector<DracoAttribute>& attributes);

  private:
    [[nodiscard]] Result<DracoMesh> decode(Bytes packed, const std::vector<DracoAttribute>& attributes);

    const SceneTools& tools_;
    bool required_;
    std::optional<Error> failed_;
    std::map<std::vector<std::uint64_t>, DracoMesh> known_;
};

}  // namespace snug::gltf
