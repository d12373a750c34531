#include "snug/mesh/clean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "snug/mesh/cap.h"

namespace snug {
namespace {

constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

/// Without the vertices that no triangle uses; the others keep their order.
Mesh compacted(const Mesh& mesh) {
    std::vector<std::uint32_t> number(mesh.vertices.size(), kUnused);
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle) number[v] = 0;
    Mesh rest;
    rest.origin = mesh.origin;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] == kUnused) continue;
        number[v] = static_cast<std::uint32_t>(rest.vertices.size());
        rest.vertices.push_back(mesh.vertices[v]);
    }
    rest.triangles.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) rest.triangles.push_back({number[a], number[b], number[c]});
    return rest;
}

double area(const Mesh& mesh, const Triangle& t) {
    const Vec3d a = vec_cast<double>(mesh.vertices[t[0]]);
    const Vec3d n =
        cross(vec_cast<double>(mesh.vertices[t[1]]) - a, vec_cast<double>(mesh.vertices[t[2]]) - a);
    return 0.5 * std::sqrt(dot(n, n));
}

/// Cuts triangles at a plane.
class PlaneCut {
  public:
    PlaneCut(const Mesh& mesh, Vec3d normal, double distance) : mesh_(mesh) {
        cut_.origin = mesh.origin;
        cut_.vertices = mesh.vertices;
        height_.reserve(mesh.vertices.size());
        for (const Vec3f& v : mesh.vertices) height_.push_back(dot(normal, vec_cast<double>(v)) - distance);
    }

    Mesh take() && {
        for (const Triangle& triangle : mesh_.triangles) add(triangle);
        return compacted(cut_);
    }

  private:
    void add(const Triangle& triangle) {
        std::array<std::uint32_t, 4> kept{};
        std::size_t count = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
            if (height_[a] >= 0) kept[count++] = a;
            if ((height_[a] > 0 && height_[b] < 0) || (height_[a] < 0 && height_[b] > 0))
                kept[count++] = crossing(a, b);
        }
        for (std::size_t i = 1; i + 1 < count; ++i) cut_.triangles.push_back({kept[0], kept[i], kept[i + 1]});
    }

    /// One for each edge, and the same to the bit for each edge between the same two places.
    std::uint32_t crossing(std::uint32_t a, std::uint32_t b) {
        const auto key = [this](std::uint32_t v) {
            const Vec3f p = mesh_.vertices[v];
            return std::tuple(p.x, p.y, p.z);
        };
        if (key(b) < key(a)) std::swap(a, b);
        const auto [at, is_new] =
            crossings_.try_emplace({a, b}, static_cast<std::uint32_t>(cut_.vertices.size()));
        if (is_new) {
            const Vec3d from = vec_cast<double>(mesh_.vertices[a]), to = vec_cast<double>(mesh_.vertices[b]);
            const double t = height_[a] / (height_[a] - height_[b]);
            cut_.vertices.push_back(vec_cast<float>(from + (to - from) * t));
        }
        return at->second;
    }

    const Mesh& mesh_;
    Mesh cut_;
    std::vector<double> height_;  ///< above the plane
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings_;
};

/// Loops that lie in the plane, but for rounding to float.
std::vector<std::vector<std::uint32_t>> loops_in_plane(const Mesh& mesh, Vec3d normal, double distance) {
    const Box3d box = bounds(mesh);
    double farthest = 0;
    for (int axis = 0; axis < 3; ++axis)
        farthest = std::max({farthest, std::fabs(box.min[axis]), std::fabs(box.max[axis])});
    const double rounding = 1e-6 * farthest;
    std::vector<std::vector<std::uint32_t>> loops = measure(mesh).holes;
    const auto leaves = [&](const std::vector<std::uint32_t>& loop) {
        return std::any_of(loop.begin(), loop.end(), [&](std::uint32_t v) {
            return std::fabs(dot(normal, vec_cast<double>(mesh.vertices[v])) - distance) > rounding;
        });
    };
    loops.erase(std::remove_if(loops.begin(), loops.end(), leaves), loops.end());
    return loops;
}

}  // namespace

std::vector<PartShare> part_shares(const Mesh& mesh, const MeshMeasure& measure) {
    std::vector<PartShare> shares(measure.parts.size());
    double whole = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const double own = area(mesh, mesh.triangles[t]);
        shares[measure.part_of_triangle[t]].share += own;
        whole += own;
    }
    for (std::size_t p = 0; p < shares.size(); ++p) {
        shares[p].number = p + 1;
        shares[p].triangles = measure.parts[p].triangles;
        shares[p].bounds = measure.parts[p].bounds;
        shares[p].share = whole > 0 ? shares[p].share / whole : 0;
    }
    return shares;
}

Mesh without_parts(const Mesh& mesh, const MeshMeasure& measure, const std::vector<bool>& drop) {
    Mesh rest = mesh;
    rest.triangles.clear();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (!drop[measure.part_of_triangle[t]]) rest.triangles.push_back(mesh.triangles[t]);
    return compacted(rest);
}

Mesh cut_off(const Mesh& mesh, Vec3d normal, double distance) {
    const double length = std::sqrt(dot(normal, normal));
    normal = normal * (1 / length);
    distance /= length;
    if (mesh.is_cloud()) {
        Mesh rest;
        rest.origin = mesh.origin;
        for (const Vec3f& v : mesh.vertices)
            if (dot(normal, vec_cast<double>(v)) >= distance) rest.vertices.push_back(v);
        return rest;
    }
    Mesh rest = PlaneCut(mesh, normal, distance).take();
    if (rest.triangles.empty()) return rest;
    rest = capped(rest, loops_in_plane(rest, normal, distance));
    rest.cap_vertices = 0;  // they belong to the object now
    return rest;
}

}  // namespace snug
