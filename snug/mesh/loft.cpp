#include "snug/mesh/loft.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>

namespace snug {
namespace {

std::uint32_t add_vertex(Mesh& mesh, Vec3d p) {
    mesh.vertices.push_back(vec_cast<float>(p));
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

std::uint32_t add_ring_of_vertices(Mesh& mesh, const Ring& ring) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vec3d& p : ring) add_vertex(mesh, p);
    return first;
}

/// A fan over the ring that begins at vertex `first`; counter-clockwise if `up`.
void close_end(Mesh& mesh, const Ring& ring, std::uint32_t first, bool up) {
    if (std::all_of(ring.begin(), ring.end(), [&](Vec3d p) { return p == ring.front(); })) return;
    Vec3d sum;
    for (const Vec3d& p : ring) sum = sum + p;
    const std::uint32_t tip = add_vertex(mesh, sum * (1.0 / static_cast<double>(ring.size())));
    const auto n = static_cast<std::uint32_t>(ring.size());
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = first + i, b = first + (i + 1) % n;
        mesh.triangles.push_back(up ? Triangle{tip, a, b} : Triangle{tip, b, a});
    }
}

}  // namespace

void join_rings(Mesh& mesh, std::uint32_t lower, std::uint32_t upper, std::uint32_t n) {
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t next = (i + 1) % n;
        mesh.triangles.push_back({lower + i, lower + next, upper + next});
        mesh.triangles.push_back({lower + i, upper + next, upper + i});
    }
}

void add_loft(Mesh& mesh, std::span<const Ring> rings) {
    const auto n = static_cast<std::uint32_t>(rings.front().size());
    std::uint32_t lower = add_ring_of_vertices(mesh, rings.front());
    const std::uint32_t first = lower;
    for (std::size_t r = 1; r < rings.size(); ++r) {
        assert(rings[r].size() == n);
        const std::uint32_t upper = add_ring_of_vertices(mesh, rings[r]);
        join_rings(mesh, lower, upper, n);
        lower = upper;
    }
    close_end(mesh, rings.front(), first, false);
    close_end(mesh, rings.back(), lower, true);
}

}  // namespace snug
