#pragma once

#include <span>
#include <string>

#include "snug/drawing/svg.h"
#include "snug/formats/mesh_files.h"
#include "snug/picture/relief.h"

namespace snug {

/// A foam half as shaded polygons, drawn back to front: `faces` are its visible_faces(). Deep floors are
/// darker. Blocks get edges where they are large enough on the page to be told apart.
[[nodiscard]] std::string foam_drawing(const Page& page, const Relief& relief, std::span<const Face> faces,
                                       Color foam);

}  // namespace snug
