#pragma once

#include <functional>

#include "snug/base/vec.h"
#include "snug/mesh/mesh.h"

namespace snug::test {

/// Adds a mesh to another as a part of its own.
void append(Mesh& mesh, const Mesh& other);

[[nodiscard]] Mesh box_mesh(Vec3d min, Vec3d max);

/// Rings of vertices joined to a torus, or to a sphere if the rings do not close and the first and last are
/// points.
[[nodiscard]] Mesh ringed_mesh(int rings, int around, bool rings_close,
                               const std::function<Vec3d(int ring, int step)>& position);

[[nodiscard]] Mesh sphere_mesh(double radius, int rings = 100);

/// Its axis is z.
[[nodiscard]] Mesh torus_mesh(double large, double small);

/// Every triangle turned round.
[[nodiscard]] Mesh inside_out(Mesh mesh);

/// Of a closed mesh, by the divergence theorem.
[[nodiscard]] double enclosed_volume(const Mesh& mesh);

}  // namespace snug::test
