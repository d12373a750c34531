#include "tests/support/broken_foams.h"

#include <algorithm>
#include <cstdint>

namespace snug::test {

Mesh random_soup(Random& random, Vec3d size, int triangles) {
    Mesh mesh;
    for (int t = 0; t < triangles; ++t) {
        const double share = random.chance(0.5) ? 0.15 : 1;
        const Vec3d at{random.unit(), random.unit(), random.unit()};
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (int corner = 0; corner < 3; ++corner) {
            Vec3d p;
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = std::clamp(at[axis] + share * random.between(-1, 1), 0.0, 1.0) * size[axis];
            mesh.vertices.push_back(vec_cast<float>(p));
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

Broken broken_by(const Packing& packing, const Blocks& below, const Blocks& above) {
    const Vec3i n = packing.space.blocks;
    Broken broken;
    for (int j = 0; j < n.y; ++j)
        for (int k = 0; k < n.z; ++k) {
            bool upper_below = false;
            int lowest = n.x, highest = -1;
            for (int i = 0; i < n.x; ++i) {
                const auto column = packing.blocks.index(j, k);
                const bool lower = packing.foams->piece(Half::lower)[column].contains(i);
                const bool upper = packing.foams->piece(Half::lid)[column].contains(i);
                broken.in_room += (lower && below.cut(i, j, k)) + (upper && above.cut(i, j, k));
                broken.in_the_way += lower && (upper || upper_below);
                upper_below |= upper;
                if (below.cut(i, j, k)) lowest = std::min(lowest, i);
                if (above.cut(i, j, k)) highest = i;
            }
            broken.crossed += highest >= 0 && lowest < n.x && lowest > highest + 1;
        }
    return broken;
}

}  // namespace snug::test
