#pragma once

#include "snug/formats/ply_header.h"

namespace snug {

/// Programs have their own words for what a PLY holds. Gives the elements that are clearly vertices or faces,
/// and the coordinates of vertices, the names that the format has for them, and finds the corners of faces.
void use_known_names(PlyHeader& header);

}  // namespace snug
