#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "snug/base/box.h"
#include "snug/base/vec.h"

namespace snug {

/// What a reader learned beside the geometry, and what it could not take over.
struct ReadNotes {
    bool in_mm = false;  ///< the format states its unit: lengths are in mm and no unit multiplies them again
    std::size_t faces = 0;            ///< that the file has, with those that were left out
    std::size_t left_out_faces = 0;   ///< of fewer than three corners, or with one that is no number
    std::size_t left_out_points = 0;  ///< of a cloud, places that are no numbers
    bool no_end = false;              ///< the file stops where its format wants an end to be said
    std::vector<std::string> left_out_objects{};  ///< a bundle's other objects, by name
};

/// The object: a triangle mesh of any quality. Open, self-crossing, badly wound and degenerate triangles are
/// normal. Every vertex is finite and used by a triangle, every index is in range: readers see to that.
struct Mesh {
    std::vector<Vec3f> vertices;  ///< relative to `origin`
    std::vector<Triangle> triangles;
    Vec3d origin;  ///< scans lie at survey coordinates that a float cannot hold
    /// The last vertices that only caps use (cap.h): they count for what is cut, not for where the centre is.
    std::size_t cap_vertices = 0;
    ReadNotes read{};

    /// Points without triangles: every other rule of a mesh holds, but each vertex stands for itself.
    [[nodiscard]] bool is_cloud() const { return triangles.empty() && !vertices.empty(); }
};

/// Bounding box of the vertices, relative to mesh.origin.
[[nodiscard]] Box3d bounds(const Mesh& mesh);

/// Every length times `factor` (origin included): from a file's unit to millimetres.
[[nodiscard]] Mesh scaled(Mesh mesh, double factor);

}  // namespace snug
