#pragma once

#include <vector>

#include "snug/check/packing.h"
#include "snug/mesh/mesh.h"

#include "tests/support/brute_force.h"
#include "tests/support/random.h"

namespace snug::test {

/// Triangles of all sizes within a box of this size.
[[nodiscard]] Mesh random_soup(Random& random, Vec3d size, int triangles);

/// What a piece keeps where an object, grown for that piece, cuts; and where a piece lies in another's or an
/// object's way out.
struct Broken {
    long long in_room = 0;
    long long in_the_way = 0;
    long long crossed = 0;  ///< columns whose lower foam has to end above where the upper may begin
};

/// Block by block, from a cut of its own for each half.
[[nodiscard]] Broken broken_by(const Packing& packing, const Blocks& below, const Blocks& above);
/// Of several layers, the lowest first.
[[nodiscard]] Broken broken_by(const Packing& packing, const std::vector<Blocks>& below,
                               const std::vector<Blocks>& above);

}  // namespace snug::test
