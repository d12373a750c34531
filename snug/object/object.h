#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "snug/base/box.h"
#include "snug/base/finding.h"
#include "snug/base/rotation.h"
#include "snug/design/design.h"
#include "snug/formats/triangle_stream.h"
#include "snug/mesh/measure.h"
#include "snug/mesh/mesh.h"
#include "snug/mesh/shell.h"
#include "snug/object/clean_object.h"
#include "snug/object/prepared_surface.h"
#include "snug/object/triangle_groups.h"

namespace snug {

/// The object's own mesh is its surface.
struct OwnMesh {};

/// A cloud of points, each of which counts as a ball (point_radius.h).
struct PointBalls {
    Mesh cloud;                 ///< its points, mm
    std::vector<float> radius;  ///< of each of them, mm
};

/// Triangles that are read anew from their file whenever depths are wanted.
struct StreamedTriangles {
    TriangleStream stream;
    FileToObject to_object;
    Vec3d rotation_deg;  ///< that a first pass turned the object by ...
    Box3d turned;        ///< ... and its bounding box then
    /// What the surface meets: marked by a pass for depths on its way, until the object has its stand-in.
    std::shared_ptr<MetCubes> cubes;
};

/// What an object's depth maps are made of. A new kind supplies a placement (space/place_object.h), depth
/// maps (depth/object_depths.h) and what is known of it (check/find_object_problems.h).
using Surface = std::variant<OwnMesh, PointBalls, StreamedTriangles>;

/// What the file had, before anything was dropped.
struct ReadCounts {
    std::size_t vertices = 0;  ///< points of a cloud; 0 where a stream does not say
    std::size_t triangles = 0;
};

/// What is missing of a surface.
struct MissingSurface {
    Mesh spans;           ///< what would span the holes, in mm; of a mesh empty where they are capped
    bool capped = false;  ///< there were some, and the design wanted them closed
};

/// An object in millimetres, ready to be packed any number of times.
struct Object {
    std::string name;  ///< its file's, without folders; may be empty
    /// Tells it apart from every other object, and from itself before a change, where results are kept for
    /// later (depth/item_depths.h); 0: nothing is kept of it.
    std::uint64_t edition = 0;
    ObjectOptions options;  ///< that it was prepared with
    Surface surface;
    /// With its caps if the design asks for them. Of another kind than OwnMesh a closed stand-in around the
    /// object (shell.h), to look at and to search with; of a stream empty until take_stand_in().
    Mesh mesh;
    std::optional<PreparedSurface> prepared;  ///< of `mesh`, see prepare_for_many()
    MeshMeasure measure;  ///< of the mesh as it was read; of another kind the bounds alone are known
    MissingSurface missing;
    CleanReport clean;  ///< its parts as they were read, and what the design had taken away
    ReadCounts read;
    /// What else is known of its file, such as that it is not the one that a project was made with.
    std::vector<Finding> findings;

    /// A mesh in memory: everything can be known of it, gaps and undercuts too.
    [[nodiscard]] bool whole() const { return std::holds_alternative<OwnMesh>(surface); }
    [[nodiscard]] bool is_cloud() const { return std::holds_alternative<PointBalls>(surface); }
    [[nodiscard]] bool is_streamed() const { return std::holds_alternative<StreamedTriangles>(surface); }
};

}  // namespace snug
