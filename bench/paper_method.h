#pragma once

#include <memory>

#include "snug/depth/depth_map.h"
#include "snug/foam/block_map.h"
#include "snug/mesh/mesh.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

namespace snug::bench {

/// The paper's own way to a block map (Fukusato and Kita 2025, section 3.2), to be compared with: two depth
/// textures of the turned object, from +x and from -x, drawn from vertex buffers by Mesa's software
/// rasteriser through OSMesa, read back and pooled over each column. It samples: what lies between the texels
/// is missed. LP_NUM_THREADS=0 in the environment keeps Mesa on one thread.
class PaperMethod {
  public:
    /// Uploads the mesh; textures of `texels` x `texels` over the space's y and z. Ends the program where
    /// OSMesa cannot be used.
    PaperMethod(const Mesh& mesh, int texels);
    ~PaperMethod();
    PaperMethod(const PaperMethod&) = delete;
    PaperMethod& operator=(const PaperMethod&) = delete;

    [[nodiscard]] DepthMap depth_map(const Placement& placement, const DesignSpace& space);
    [[nodiscard]] const char* renderer() const;

  private:
    struct Context;
    std::unique_ptr<Context> context_;
};

}  // namespace snug::bench
