#include "snug/mesh/surface_nets.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace snug {
namespace {

constexpr int kRelaxations = 3;
constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();

class SurfaceNets {
  public:
    SurfaceNets(const Field& field, const Box3d& box, double step) : field_(field), step_(step) {
        for (int axis = 0; axis < 3; ++axis)
            cells_[axis] = std::max(1, static_cast<int>(std::ceil(box.size()[axis] / step)));
        // The grid's middle is the box's, so that a symmetric solid in the middle gets a symmetric mesh.
        start_ = box.centre() - vec_cast<double>(cells_) * (step / 2);
        value_.resize(static_cast<std::size_t>(cells_.x + 1) * (cells_.y + 1) * (cells_.z + 1));
        vertex_.assign(value_.size(), kNoVertex);
    }

    Mesh mesh() {
        for_each_node(1, [&](Vec3i node) { value_[index(node)] = field_(place(node)); });
        for_each_node(0, [&](Vec3i cell) { add_vertex(cell); });
        for_each_node(0, [&](Vec3i node) {
            for (int axis = 0; axis < 3; ++axis) add_quadrilateral(node, axis);
        });
        for (int round = 0; round < kRelaxations; ++round) relax();
        return std::move(mesh_);
    }

  private:
    template <class Visit>
    void for_each_node(int more, Visit visit) {
        for (int i = 0; i < cells_.x + more; ++i)
            for (int j = 0; j < cells_.y + more; ++j)
                for (int k = 0; k < cells_.z + more; ++k) visit(Vec3i{i, j, k});
    }
    [[nodiscard]] std::size_t index(Vec3i node) const {
        return (static_cast<std::size_t>(node.x) * (cells_.y + 1) + node.y) * (cells_.z + 1) + node.z;
    }
    [[nodiscard]] Vec3d place(Vec3i node) const { return start_ + vec_cast<double>(node) * step_; }
    [[nodiscard]] bool inside(Vec3i node) const { return value_[index(node)] < 0; }

    /// In the middle of the places where the surface crosses the cell's edges.
    void add_vertex(Vec3i cell) {
        Vec3d sum;
        int crossings = 0;
        for (int axis = 0; axis < 3; ++axis) {
            for (int side = 0; side < 4; ++side) {
                Vec3i a = cell;
                a[(axis + 1) % 3] += side & 1;
                a[(axis + 2) % 3] += side >> 1;
                Vec3i b = a;
                b[axis] += 1;
                if (inside(a) == inside(b)) continue;
                const double at_a = value_[index(a)], at_b = value_[index(b)];
                sum = sum + place(a) + (place(b) - place(a)) * (at_a / (at_a - at_b));
                ++crossings;
            }
        }
        if (crossings == 0) return;
        vertex_[index(cell)] = static_cast<std::uint32_t>(mesh_.vertices.size());
        mesh_.vertices.push_back(vec_cast<float>(sum * (1.0 / crossings)));
    }

    /// Around the grid edge from a node along an axis.
    void add_quadrilateral(Vec3i node, int axis) {
        Vec3i end = node;
        end[axis] += 1;
        if (inside(node) == inside(end)) return;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        assert(node[u] > 0 && node[v] > 0);  // the solid lies within the grid
        std::uint32_t corner[4];
        for (int i = 0; i < 4; ++i) {
            Vec3i cell = node;
            cell[u] -= i == 0 || i == 3 ? 1 : 0;
            cell[v] -= i < 2 ? 1 : 0;
            corner[i] = vertex_[index(cell)];
        }
        if (inside(end)) std::swap(corner[1], corner[3]);
        const auto squared = [&](int a, int b) {
            const Vec3f d = mesh_.vertices[corner[a]] - mesh_.vertices[corner[b]];
            return dot(d, d);
        };
        const int first = squared(0, 2) <= squared(1, 3) ? 0 : 1;
        const auto at = [&](int i) { return corner[(first + i) % 4]; };
        mesh_.triangles.push_back({at(0), at(1), at(2)});
        mesh_.triangles.push_back({at(2), at(3), at(0)});
    }

    /// Every vertex to the middle of its neighbours, which evens the triangles, and back onto the surface.
    void relax() {
        std::vector<Vec3d> sum(mesh_.vertices.size());
        std::vector<double> neighbours(mesh_.vertices.size());
        for (const Triangle& t : mesh_.triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
                sum[t[i]] = sum[t[i]] + vec_cast<double>(mesh_.vertices[t[(i + 1) % 3]]);
                ++neighbours[t[i]];
            }
        }
        for (std::size_t v = 0; v < sum.size(); ++v)
            mesh_.vertices[v] = vec_cast<float>(drawn_onto_surface(sum[v] * (1 / neighbours[v])));
    }

    /// One of Newton's steps along the gradient, not longer than half the grid's width.
    [[nodiscard]] Vec3d drawn_onto_surface(Vec3d p) const {
        const double h = step_ / 64, here = field_(p);
        const Vec3d rise{field_({p.x + h, p.y, p.z}) - here, field_({p.x, p.y + h, p.z}) - here,
                         field_({p.x, p.y, p.z + h}) - here};
        const double steepness = std::sqrt(dot(rise, rise));
        if (steepness <= 0) return p;
        return p - rise * (std::clamp(h * here / steepness, -step_ / 2, step_ / 2) / steepness);
    }

    const Field& field_;
    double step_;
    Vec3i cells_;
    Vec3d start_;
    std::vector<double> value_;          // for each node
    std::vector<std::uint32_t> vertex_;  // for each cell, filed at its lowest node
    Mesh mesh_;
};

}  // namespace

Mesh surface_nets(const Field& field, const Box3d& box, double step) {
    return SurfaceNets(field, box, step).mesh();
}

}  // namespace snug
