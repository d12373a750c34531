#include "snug/mesh/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "snug/mesh/edges.h"
#include "snug/mesh/seams.h"

namespace snug {
namespace {

constexpr std::uint32_t kNoPart = std::numeric_limits<std::uint32_t>::max();

/// Union-find over vertices.
class Connections {
  public:
    explicit Connections(const std::vector<std::uint32_t>& weld) : parent_(weld) {}

    std::uint32_t root(std::uint32_t v) {
        while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
        return v;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

double squared_diagonal(const Box3d& box) {
    return dot(box.size(), box.size());
}

/// Fills parts and part_of_triangle, in the order of their first triangles.
void find_parts_of(const Mesh& mesh, const std::vector<std::uint32_t>& weld, MeshMeasure& result) {
    Connections connections(weld);
    for (const Triangle& t : mesh.triangles) {
        connections.join(t[0], t[1]);
        connections.join(t[1], t[2]);
    }
    std::vector<std::uint32_t> part_of_root(mesh.vertices.size(), kNoPart);
    result.part_of_triangle.resize(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        std::uint32_t& part = part_of_root[connections.root(mesh.triangles[t][0])];
        if (part == kNoPart) {
            part = static_cast<std::uint32_t>(result.parts.size());
            result.parts.push_back({0, {}, static_cast<std::uint32_t>(t)});
        }
        result.part_of_triangle[t] = part;
        ++result.parts[part].triangles;
        for (const std::uint32_t v : mesh.triangles[t])
            result.parts[part].bounds.include(vec_cast<double>(mesh.vertices[v]));
    }
}

void sort_parts_by_size(MeshMeasure& result) {
    std::vector<std::uint32_t> order(result.parts.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return squared_diagonal(result.parts[a].bounds) > squared_diagonal(result.parts[b].bounds);
    });
    std::vector<MeshPart> sorted;
    std::vector<std::uint32_t> place(order.size());
    for (const std::uint32_t part : order) {
        place[part] = static_cast<std::uint32_t>(sorted.size());
        sorted.push_back(result.parts[part]);
    }
    result.parts = std::move(sorted);
    for (std::uint32_t& part : result.part_of_triangle) part = place[part];
}

/// By the divergence theorem: tetrahedra over the triangles with their tip in the middle, where they cancel
/// best.
void measure_solid(const Mesh& mesh, Vec3d middle, MeshMeasure& result) {
    double sum = 0;
    Vec3d moment;
    for (const Triangle& t : mesh.triangles) {
        const Vec3d a = vec_cast<double>(mesh.vertices[t[0]]) - middle;
        const Vec3d b = vec_cast<double>(mesh.vertices[t[1]]) - middle;
        const Vec3d c = vec_cast<double>(mesh.vertices[t[2]]) - middle;
        const double six_volumes = dot(a, cross(b, c));
        sum += six_volumes;
        moment = moment + (a + b + c) * six_volumes;
    }
    result.volume = std::fabs(sum) / 6;
    const Vec3d centre = middle + moment * (1 / (4 * sum));
    if (result.bounds.contains(centre)) result.centre = centre;
}

}  // namespace

MeshMeasure measure(const Mesh& mesh) {
    MeshMeasure result;
    result.bounds = bounds(mesh);
    std::vector<std::uint32_t> weld = welded(mesh);
    EdgeCensus edges = census_of_edges(mesh, weld);
    if (!edges.boundary.empty() && weld_seams(mesh, edges.boundary, weld))
        edges = census_of_edges(mesh, weld);
    find_parts_of(mesh, weld, result);
    sort_parts_by_size(result);
    result.watertight = edges.watertight;
    if (edges.watertight) measure_solid(mesh, result.bounds.centre(), result);
    result.holes = boundary_loops(edges.boundary);
    return result;
}

}  // namespace snug
