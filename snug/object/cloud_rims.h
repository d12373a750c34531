#pragma once

#include <cstdint>
#include <vector>

#include "snug/mesh/mesh.h"
#include "snug/object/cloud_places.h"

namespace snug {

/// The rims of what a scanner did not see: loops of vertices around places where the cloud ends, such as the
/// base of what stood on a table. A point lies on a rim where its neighbours, seen along the surface's
/// normal, leave a gap of more than 120 degrees (after Bendels, Schnabel and Klein, Detecting Holes in Point
/// Set Surfaces, 2006); points in a row of rim points make a rim, and of each the convex outline in its own
/// plane is what is given, ready for span_of_loops() and capped(). Rims of a few points are passed over.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> cloud_rims(const CloudPlaces& places);

}  // namespace snug
