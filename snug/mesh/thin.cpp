#include "snug/mesh/thin.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace snug {
namespace {

constexpr std::size_t kBitsPerAxis = 20;
constexpr double kMostCubes = 1 << kBitsPerAxis;
/// Each further try has cubes this much larger.
constexpr double kCoarser = 1.25;
/// So much more than what the rounding of a distance can take away.
constexpr double kRoundedUp = 1 + 1e-12;

/// Which vertices fall together: for each vertex its cluster, numbered in the order of their first vertices.
struct Clusters {
    std::vector<std::uint32_t> of_vertex;
    std::size_t count = 0;

    [[nodiscard]] Triangle corners(const Triangle& t) const {
        return {of_vertex[t[0]], of_vertex[t[1]], of_vertex[t[2]]};
    }
};

Clusters cluster(const Mesh& mesh, const Box3d& box, double cube) {
    Clusters clusters;
    clusters.of_vertex.reserve(mesh.vertices.size());
    // Only asked, never walked through: its order decides nothing.
    std::unordered_map<std::uint64_t, std::uint32_t> known;
    const auto cell = [cube](double from_start) {
        return static_cast<std::uint64_t>(std::clamp(std::floor(from_start / cube), 0.0, kMostCubes - 1));
    };
    for (const Vec3f& vertex : mesh.vertices) {
        const Vec3d p = vec_cast<double>(vertex) - box.min;
        const std::uint64_t key = (cell(p.x) << (2 * kBitsPerAxis)) | (cell(p.y) << kBitsPerAxis) | cell(p.z);
        const auto next = static_cast<std::uint32_t>(known.size());
        clusters.of_vertex.push_back(known.emplace(key, next).first->second);
    }
    clusters.count = known.size();
    return clusters;
}

/// Triangles that still have three corners.
std::vector<Triangle> remaining(const Mesh& mesh, const Clusters& clusters) {
    std::vector<Triangle> triangles;
    for (const Triangle& t : mesh.triangles) {
        const Triangle moved = clusters.corners(t);
        if (moved[0] != moved[1] && moved[1] != moved[2] && moved[2] != moved[0]) triangles.push_back(moved);
    }
    return triangles;
}

/// A rod that is thinner than a cube has no such triangles: its line, and the place of a part that is smaller
/// than a cube, stay as triangles without area, so that nothing of the object is forgotten.
void add_lines_and_points(const Mesh& mesh, const Clusters& clusters, std::vector<Triangle>& triangles) {
    // Only asked, never walked through: its order decides nothing.
    std::unordered_set<std::uint64_t> lines;
    std::vector<std::uint8_t> used(clusters.count, 0);
    const auto is_new = [&](std::uint32_t a, std::uint32_t b) {
        used[a] = used[b] = 1;
        return lines.insert(std::uint64_t{std::min(a, b)} << 32 | std::max(a, b)).second;
    };
    for (const Triangle& t : triangles)
        for (std::size_t i = 0; i < 3; ++i) (void)is_new(t[i], t[(i + 1) % 3]);
    for (const Triangle& original : mesh.triangles) {
        const Triangle t = clusters.corners(original);
        const std::uint32_t other = t[1] != t[0] ? t[1] : t[2];
        if (other != t[0] && is_new(t[0], other)) triangles.push_back({t[0], other, other});
    }
    for (const Triangle& original : mesh.triangles) {
        const std::uint32_t place = clusters.of_vertex[original[0]];
        if (used[place] == 0) triangles.push_back({place, place, place});
        used[place] = 1;
    }
}

/// The middle of each cluster's vertices, rounded as a mesh holds it.
std::vector<Vec3f> middles(const Mesh& mesh, const Clusters& clusters) {
    std::vector<Vec3d> sums(clusters.count);
    std::vector<double> counts(clusters.count, 0);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        Vec3d& sum = sums[clusters.of_vertex[v]];
        sum = sum + vec_cast<double>(mesh.vertices[v]);
        counts[clusters.of_vertex[v]] += 1;
    }
    std::vector<Vec3f> result(clusters.count);
    for (std::size_t i = 0; i < clusters.count; ++i) result[i] = vec_cast<float>(sums[i] * (1 / counts[i]));
    return result;
}

double farthest_move(const Mesh& mesh, const Clusters& clusters, const std::vector<Vec3f>& places) {
    double farthest = 0;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const Vec3d move =
            vec_cast<double>(mesh.vertices[v]) - vec_cast<double>(places[clusters.of_vertex[v]]);
        farthest = std::max(farthest, dot(move, move));
    }
    return std::sqrt(farthest) * kRoundedUp;
}

/// Without the places that no triangle uses any more.
Mesh compacted(const std::vector<Vec3f>& places, std::vector<Triangle> triangles, Vec3d origin) {
    constexpr std::uint32_t kNotMet = 0xffff'ffff;
    std::vector<std::uint32_t> number(places.size(), kNotMet);
    Mesh mesh;
    mesh.origin = origin;
    for (Triangle& triangle : triangles) {
        for (std::uint32_t& corner : triangle) {
            std::uint32_t& place = number[corner];
            if (place == kNotMet) {
                place = static_cast<std::uint32_t>(mesh.vertices.size());
                mesh.vertices.push_back(places[corner]);
            }
            corner = place;
        }
    }
    mesh.triangles = std::move(triangles);
    return mesh;
}

}  // namespace

ThinMesh thinned(const Mesh& mesh, std::size_t most_triangles) {
    const std::size_t most = std::max<std::size_t>(most_triangles, 1);
    if (mesh.triangles.size() <= most) return {mesh, 0};
    const Box3d box = bounds(mesh);
    // A closed surface that crosses n x n cubes keeps some 2 to 8 n^2 triangles.
    const double across = std::clamp(std::sqrt(static_cast<double>(most)), 1.0, kMostCubes);
    double cube = box.longest_side() > 0 ? box.longest_side() / across : 1;
    for (;; cube *= kCoarser) {
        const Clusters clusters = cluster(mesh, box, cube);
        std::vector<Triangle> triangles = remaining(mesh, clusters);
        if (triangles.size() > most) continue;
        add_lines_and_points(mesh, clusters, triangles);
        if (triangles.size() > most) continue;
        const std::vector<Vec3f> places = middles(mesh, clusters);
        const double deviation = farthest_move(mesh, clusters, places);
        return {compacted(places, std::move(triangles), mesh.origin), deviation};
    }
}

}  // namespace snug
