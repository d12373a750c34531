#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "snug/mesh/mesh.h"

namespace snug::test {

/// Both meshes in one, vertices not shared.
inline Mesh joined(Mesh a, const Mesh& b) {
    const auto first = static_cast<std::uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    return a;
}

/// The same triangles with three vertices each that they share with none, as an STL file has them.
inline Mesh unwelded(const Mesh& mesh) {
    Mesh soup;
    soup.origin = mesh.origin;
    for (const Triangle& t : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(soup.vertices.size());
        for (const std::uint32_t v : t) soup.vertices.push_back(mesh.vertices[v]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    return soup;
}

/// An octahedron with corners at distance 1, its sides split in four `times` times: closed, convex, outward.
/// The new vertices stay on the octahedron unless `round`, which puts them at distance 1, too.
inline Mesh octahedron(int times, bool round) {
    Mesh mesh;
    mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (; times > 0; --times) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [place, is_new] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.vertices.size()));
            if (is_new) mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]) * 0.5f);
            return place->second;
        };
        std::vector<Triangle> finer;
        for (const Triangle& t : mesh.triangles) {
            const std::uint32_t ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
            for (const Triangle& part : {Triangle{t[0], ab, ca}, Triangle{t[1], bc, ab},
                                         Triangle{t[2], ca, bc}, Triangle{ab, bc, ca}})
                finer.push_back(part);
        }
        mesh.triangles = std::move(finer);
    }
    if (round)
        for (Vec3f& v : mesh.vertices) v = v * (1 / std::sqrt(dot(v, v)));
    return mesh;
}

}  // namespace snug::test
