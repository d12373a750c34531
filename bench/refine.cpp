#include "bench/refine.h"

#include <map>
#include <utility>

namespace snug::bench {

Mesh refined(const Mesh& mesh) {
    Mesh fine{mesh.vertices, {}, mesh.origin};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> midpoints;
    const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
        const auto [place, added] = midpoints.try_emplace(std::minmax(a, b), fine.vertices.size());
        if (added) fine.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]) * 0.5f);
        return place->second;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        const std::uint32_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
        fine.triangles.insert(fine.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return fine;
}

}  // namespace snug::bench
