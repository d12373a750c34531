#pragma once

#include <string_view>

#include "snug/base/result.h"
#include "snug/formats/read.h"
#include "snug/mesh/mesh.h"

// Readers for point clouds as scanners write them. They keep the promises of read.h; the result is a Mesh
// without triangles (Mesh::is_cloud()).

namespace snug {

/// XYZ and PTS text: a point a line, x y z first, further columns (colour, intensity, normal) passed over.
/// Columns stand apart by blanks, commas or semicolons. A line with one whole number alone says how many
/// points follow (PTS; several scans in one file are one cloud); comments begin with # or //; a first line
/// may name the columns. Points with a coordinate that is no number are left out and counted. Lines with
/// decimal commas are refused, since they would be read as other points.
[[nodiscard]] Result<Mesh> read_xyz(Bytes file);

/// As read_ply, and a PLY without triangles is a cloud of its vertices.
[[nodiscard]] Result<Mesh> read_ply_or_cloud(Bytes file);

/// As read_obj and read_off, and a file of vertices alone is a cloud of them.
[[nodiscard]] Result<Mesh> read_obj_or_cloud(Bytes file);
[[nodiscard]] Result<Mesh> read_off_or_cloud(Bytes file);

/// A mesh or a cloud: .xyz and .pts by the name's ending where the content is no other format, PLY, OBJ
/// and OFF of either kind, and all that read_mesh reads.
[[nodiscard]] Result<Mesh> read_mesh_or_cloud(Bytes file, std::string_view name);

}  // namespace snug
