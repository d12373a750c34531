#pragma once

#include "snug/base/box.h"
#include "snug/base/rotation.h"
#include "snug/mesh/mesh.h"
#include "snug/object/prepared_surface.h"

namespace snug {

/// Where the object lies in the design space: turned, its turned bounding box centred, then shifted.
struct Placement {
    Rotation rotation;
    Vec3d shift;   ///< added after turning: minus the turned box's centre, plus the offset
    Box3d bounds;  ///< of the placed object, in design coordinates

    [[nodiscard]] Vec3d operator()(Vec3f vertex) const { return rotation(vec_cast<double>(vertex)) + shift; }
};

/// The placement by Euler angles psi, theta, phi (degrees; see rotation_from_euler) and an offset in mm. Caps
/// do not decide where the object's centre is, so that an object lies the same with and without them.
[[nodiscard]] Placement place(const Mesh& mesh, Vec3d rotation_deg, Vec3d offset_mm);
/// Of an object whose turned bounding box is known.
[[nodiscard]] Placement place(const Box3d& turned, const Rotation& rotation, Vec3d offset_mm);
/// The same to the bit, without a pass over all vertices.
[[nodiscard]] Placement place(const PreparedSurface& surface, Vec3d rotation_deg, Vec3d offset_mm);

}  // namespace snug
