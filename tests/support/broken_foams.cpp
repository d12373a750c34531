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
    return broken_by(packing, std::vector{below}, std::vector{above});
}

Broken broken_by(const Packing& packing, const std::vector<Blocks>& below, const std::vector<Blocks>& above) {
    const Vec3i n = packing.space.blocks;
    const auto layers = static_cast<int>(below.size());
    const auto pieces = static_cast<int>(packing.foams->pieces.size());
    Broken broken;
    for (int j = 0; j < n.y; ++j)
        for (int k = 0; k < n.z; ++k) {
            // What was met on the way up: the highest piece, and the lowest layer that no piece below it may
            // lie above, for it would hold its items down.
            int highest_piece = 0;
            std::vector<bool> met(below.size(), false);
            for (int i = 0; i < n.x; ++i) {
                for (int p = 0; p < pieces; ++p) {
                    if (!packing.foams->pieces[static_cast<std::size_t>(p)](j, k).contains(i)) continue;
                    broken.in_the_way += p < highest_piece;
                    highest_piece = std::max(highest_piece, p);
                    for (int layer = 0; layer < layers; ++layer) {
                        const auto at = static_cast<std::size_t>(layer);
                        broken.in_room += (layer >= p ? below[at] : above[at]).cut(i, j, k);
                        broken.in_the_way += layer >= p && met[at];
                    }
                }
                for (std::size_t layer = 0; layer < below.size(); ++layer)
                    if (below[layer].cut(i, j, k)) met[layer] = true;
            }
            std::fill(met.begin(), met.end(), false);
            for (int i = n.x; i-- > 0;) {  // and on the way down
                for (int p = 0; p < pieces; ++p)
                    if (packing.foams->pieces[static_cast<std::size_t>(p)](j, k).contains(i))
                        for (int layer = 0; layer < p; ++layer)
                            broken.in_the_way += met[static_cast<std::size_t>(layer)];
                for (std::size_t layer = 0; layer < above.size(); ++layer)
                    if (above[layer].cut(i, j, k)) met[layer] = true;
            }
            for (std::size_t layer = 0; layer < below.size(); ++layer) {
                int lowest = n.x, highest = -1;
                for (int i = 0; i < n.x; ++i) {
                    if (below[layer].cut(i, j, k)) lowest = std::min(lowest, i);
                    if (above[layer].cut(i, j, k)) highest = i;
                }
                broken.crossed += highest >= 0 && lowest < n.x && lowest > highest + 1;
            }
        }
    return broken;
}

}  // namespace snug::test
