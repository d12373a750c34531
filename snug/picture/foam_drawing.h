#pragma once

#include <span>

#include "snug/picture/canvas.h"
#include "snug/picture/relief.h"

namespace snug {

/// A foam half as shaded polygons, drawn back to front: `faces` are its visible_faces(). Deep floors are
/// darker. Blocks get edges where they are large enough on the page to be told apart.
void draw_foam(Canvas& canvas, const Page& page, const Relief& relief, std::span<const Face> faces,
               Color foam);

}  // namespace snug
