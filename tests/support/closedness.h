#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "snug/base/vec.h"

namespace snug::test {

/// An edge with its smaller end first, and the way a triangle runs through it.
struct DirectedEdge {
    std::uint32_t low, high;
    bool ascending;
};

[[nodiscard]] inline std::vector<DirectedEdge> sorted_edges(std::span<const Triangle> triangles) {
    std::vector<DirectedEdge> edges;
    edges.reserve(triangles.size() * 3);
    for (const Triangle& t : triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = t[i], to = t[(i + 1) % 3];
            edges.push_back({std::min(from, to), std::max(from, to), from < to});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const DirectedEdge& a, const DirectedEdge& b) {
        return std::array{a.low, a.high, std::uint32_t{a.ascending}} <
               std::array{b.low, b.high, std::uint32_t{b.ascending}};
    });
    return edges;
}

/// Calls visit(low, high, ascending, descending) once for each edge, with the number of triangles each way.
template <class Visit>
void for_each_edge(std::span<const Triangle> triangles, Visit visit) {
    const std::vector<DirectedEdge> edges = sorted_edges(triangles);
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
        std::size_t ascending = 0;
        for (;
             end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high;
             ++end)
            ascending += edges[end].ascending ? 1 : 0;
        visit(edges[begin].low, edges[begin].high, ascending, end - begin - ascending);
    }
}

/// Every edge, told apart by its vertices' indices, has exactly two triangles, one each way.
[[nodiscard]] inline ::testing::AssertionResult every_edge_has_two_triangles(
    std::span<const Triangle> triangles) {
    ::testing::AssertionResult result = ::testing::AssertionSuccess();
    for_each_edge(triangles, [&](std::uint32_t low, std::uint32_t high, std::size_t up, std::size_t down) {
        if (result && (low == high || up != 1 || down != 1))
            result = ::testing::AssertionFailure()
                     << "edge " << low << "-" << high << " has " << up << " + " << down << " triangles";
    });
    return result;
}

/// For each vertex the first vertex in order that stands at the same position (-0 = 0).
[[nodiscard]] inline std::vector<std::uint32_t> welded_by_position(std::span<const Vec3f> vertices) {
    std::vector<std::uint32_t> order(vertices.size()), weld(vertices.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        const Vec3f p = vertices[a], q = vertices[b];
        if (p.x != q.x) return p.x < q.x;
        if (p.y != q.y) return p.y < q.y;
        if (p.z != q.z) return p.z < q.z;
        return a < b;
    };
    std::sort(order.begin(), order.end(), before);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
        weld[order[i]] = same ? weld[order[i - 1]] : order[i];
    }
    return weld;
}

/// Every edge, told apart by its ends' positions, has equally many triangles each way; and there are
/// triangles.
[[nodiscard]] inline ::testing::AssertionResult closed_when_welded(std::span<const Vec3f> vertices,
                                                                   std::span<const Triangle> triangles) {
    if (triangles.empty()) return ::testing::AssertionFailure() << "no triangles";
    const std::vector<std::uint32_t> weld = welded_by_position(vertices);
    std::vector<Triangle> joined(triangles.begin(), triangles.end());
    for (Triangle& t : joined)
        for (std::uint32_t& vertex : t) vertex = weld[vertex];
    ::testing::AssertionResult result = ::testing::AssertionSuccess();
    for_each_edge(joined, [&](std::uint32_t low, std::uint32_t high, std::size_t up, std::size_t down) {
        if (result && (low == high || up != down))
            result = ::testing::AssertionFailure() << "welded edge " << low << "-" << high << " has " << up
                                                   << " + " << down << " triangles";
    });
    return result;
}

/// By the divergence theorem: positive if the triangles face outward.
[[nodiscard]] inline double signed_volume(std::span<const Vec3f> vertices,
                                          std::span<const Triangle> triangles) {
    double six_volumes = 0;
    for (const Triangle& t : triangles) {
        const Vec3d a = vec_cast<double>(vertices[t[0]]), b = vec_cast<double>(vertices[t[1]]);
        six_volumes += dot(a, cross(b, vec_cast<double>(vertices[t[2]])));
    }
    return six_volumes / 6;
}

}  // namespace snug::test
