#pragma once

#include <optional>
#include <string>
#include <vector>

#include "snug/mesh/mesh.h"

namespace snug::bench {

struct NamedMesh {
    std::string name;
    Mesh mesh;  ///< in mm, of a diagonal of kDiagonal
};

/// A file of ../shared/models, or of the folder that SNUG_MODELS names; none where it is absent.
[[nodiscard]] std::optional<Mesh> shared_model(const std::string& file_name);

constexpr double kDiagonal = 240;  // mm

/// Six objects from some thousands of vertices to some 700,000, the smallest first: shared models, refined;
/// Snug's own samples where they are absent. Vertices are displaced by seeded noise, so that refining leaves
/// no coplanar triangles.
[[nodiscard]] std::vector<NamedMesh> objects();

/// Random angles in degrees, the same in every run.
[[nodiscard]] std::vector<Vec3d> rotations(int count);

}  // namespace snug::bench
