#pragma once

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/design/zone.h"
#include "snug/mesh/mesh.h"
#include "snug/object/object.h"

namespace snug {

/// Where the object's (0, 0, 0) lies in the coordinates of its file, mm.
[[nodiscard]] Vec3d origin_mm(const Object& object);

/// The part of a surface that lies in a zone, as an object of the same kind: for depth maps, and its
/// `measure.bounds`. Triangles that a ball's edge crosses are divided until no piece is longer than 1 mm or a
/// 256th of the ball, and the pieces that it meets count; of a cloud the points whose balls meet it. Of a
/// stream a pass looks for it, and every later pass over the part divides triangles again. Fails (kind
/// `usage`) where no surface lies in the zone, where foam is to keep away from all of it, and where there is
/// no such part; for a stream where reading fails or is cancelled.
[[nodiscard]] Result<Object> zone_surface(const Object& object, const Zone& zone,
                                          const Progress& progress = {});

/// The same of the object's own mesh, which of another kind is a stand-in around it: what of it lies within
/// the zone grown by so much as the stand-in may stand off. May be empty.
[[nodiscard]] Mesh zone_of_mesh(const Object& object, const Zone& zone);

}  // namespace snug
