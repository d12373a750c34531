#pragma once

#include <cstdint>
#include <vector>

#include "snug/base/vec.h"
#include "snug/foam/block_map.h"
#include "snug/mesh/mesh.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

namespace snug::test {

/// A few blobs and tubes that overlap, some of them inside out, and cut runs at random around them.
struct RandomCase {
    Mesh mesh;
    Placement placement;
    DesignSpace space;
    BlockMap blocks;
    std::vector<Vec3d> placed;  ///< the mesh's vertices in design coordinates
};

[[nodiscard]] RandomCase random_case(std::uint64_t seed);

/// How often the object's surface winds around p, from solid angles (van Oosterom and Strackee 1983).
[[nodiscard]] int winding_number(const RandomCase& c, Vec3d p);

/// Whether p lies between hits of the line through it, by trying all triangles.
[[nodiscard]] bool in_hull(const RandomCase& c, Vec3d p);

/// How far p lies from the nearest block that is not cut or the outside of the space, and 0 outside the cut.
[[nodiscard]] double distance_to_foam(const RandomCase& c, Vec3d p);

[[nodiscard]] double distance_to_surface(const RandomCase& c, Vec3d p);

/// The radius of the largest ball around p in the gap of a closed object, and 0 outside the gap.
[[nodiscard]] double room_in_gap(const RandomCase& c, Vec3d p);

}  // namespace snug::test
