#include "snug/mesh/seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace snug {
namespace {

constexpr double kShare = 1e-6;  // of the longest side

/// A cube of space, and the first vertex in it.
struct Cell {
    std::array<std::int64_t, 3> place;
    std::uint32_t vertex;
    friend bool operator<(const Cell& a, const Cell& b) {
        return std::pair(a.place, a.vertex) < std::pair(b.place, b.vertex);
    }
};

std::array<std::int64_t, 3> place_of(Vec3f p, double side) {
    // A flat object far away on another axis would leave the range.
    const auto cell = [side](float at) {
        return static_cast<std::int64_t>(std::clamp(std::floor(at / side), -9e18, 9e18));
    };
    return {cell(p.x), cell(p.y), cell(p.z)};
}

std::vector<std::uint32_t> ends_of(std::span<const BoundaryEdge> boundary) {
    std::vector<std::uint32_t> ends;
    for (const BoundaryEdge& edge : boundary) ends.insert(ends.end(), {edge.from, edge.to});
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
}

bool lie_together(Vec3f a, Vec3f b, double apart) {
    return std::abs(a.x - b.x) <= apart && std::abs(a.y - b.y) <= apart && std::abs(a.z - b.z) <= apart;
}

}  // namespace

bool weld_seams(const Mesh& mesh, std::span<const BoundaryEdge> boundary, std::vector<std::uint32_t>& weld) {
    const Vec3d size = bounds(mesh).size();
    const double apart = kShare * std::max({size.x, size.y, size.z});
    if (!(apart > 0)) return false;
    const std::vector<std::uint32_t> ends = ends_of(boundary);
    std::vector<Cell> cells;
    for (const std::uint32_t v : ends) cells.push_back({place_of(mesh.vertices[v], apart), v});
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end(),
                            [](const Cell& a, const Cell& b) { return a.place == b.place; }),
                cells.end());

    // In the order of their numbers, each to the least that lies near it: who is welded to somebody else is
    // nobody's aim, so that no chain grows.
    bool changed = false;
    for (const std::uint32_t v : ends) {
        std::uint32_t least = v;
        const auto middle = place_of(mesh.vertices[v], apart);
        for (int near = 0; near < 27; ++near) {
            const std::array<std::int64_t, 3> place{middle[0] + near / 9 - 1, middle[1] + near / 3 % 3 - 1,
                                                    middle[2] + near % 3 - 1};
            const auto cell = std::lower_bound(cells.begin(), cells.end(), Cell{place, 0});
            if (cell == cells.end() || cell->place != place || cell->vertex >= least) continue;
            if (weld[cell->vertex] == cell->vertex &&
                lie_together(mesh.vertices[v], mesh.vertices[cell->vertex], apart))
                least = cell->vertex;
        }
        if (least == v) continue;
        weld[v] = least;
        changed = true;
    }
    if (!changed) return false;
    for (std::uint32_t& to : weld) to = weld[to];
    return true;
}

}  // namespace snug
