#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "snug/base/result.h"
#include "snug/formats/affine.h"
#include "snug/formats/gltf_buffers.h"
#include "snug/formats/gltf_nodes.h"

namespace snug::gltf {

/// Skeletons as they stand without any movement.
class Skins {
  public:
    Skins(const Json& scene, Buffers& buffers, Nodes& nodes)
        : scene_(scene), buffers_(buffers), nodes_(nodes) {}

    /// For each joint, where it takes what is bound to it: its place times its inverse bind matrix, which is
    /// one that changes nothing where the skin has none (glTF 2.0, section 3.7.3). Lives as long as this.
    [[nodiscard]] Result<const std::vector<Affine>*> pose(std::uint64_t skin);

  private:
    const Json& scene_;
    Buffers& buffers_;
    Nodes& nodes_;
    std::map<std::uint64_t, std::vector<Affine>> known_;
};

}  // namespace snug::gltf
