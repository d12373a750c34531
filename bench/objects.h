#pragma once

#include <string>
#include <vector>

#include "snug/mesh/mesh.h"

namespace snug::bench {

struct NamedMesh {
    std::string name;
    Mesh mesh;  ///< in mm, of a diagonal of kDiagonal
};

constexpr double kDiagonal = 240;  // mm

/// Six objects of 7,200 (the paper's torus) to some 700,000 vertices (the size of its two largest scans), the
/// smallest first: a sample and shared models, refined; Snug's own samples where the models are absent.
/// Vertices are displaced by seeded noise, so that refining leaves no coplanar triangles.
[[nodiscard]] std::vector<NamedMesh> objects();

/// Random angles in degrees, the same in every run.
[[nodiscard]] std::vector<Vec3d> rotations(int count);

}  // namespace snug::bench
