#include "snug/search/frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace snug {
namespace {

using Matrix = std::array<Vec3d, 3>;

constexpr std::size_t kFlats = 8;      ///< directions of flat faces that are tried with each other
constexpr double kSameFlat = 0.99985;  ///< cosine of one degree

/// Axes of a symmetric matrix by Jacobi's rotations, as rows.
Matrix principal_axes(Matrix m) {
    Matrix axes{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
    for (int sweep = 0; sweep < 16; ++sweep) {
        for (int p = 0; p < 2; ++p) {
            for (int q = p + 1; q < 3; ++q) {
                const auto row = static_cast<std::size_t>(p), other = static_cast<std::size_t>(q);
                const double off = m[row][q];
                if (off == 0) continue;
                const double ratio = (m[other][q] - m[row][p]) / (2 * off);
                const double t = (ratio < 0 ? -1 : 1) / (std::fabs(ratio) + std::sqrt(ratio * ratio + 1));
                const double c = 1 / std::sqrt(t * t + 1), s = t * c;
                for (auto& r : m) {
                    const double rp = r[p], rq = r[q];
                    r[p] = c * rp - s * rq;
                    r[q] = s * rp + c * rq;
                }
                const Vec3d rp = m[row], rq = m[other], ap = axes[row], aq = axes[other];
                m[row] = rp * c - rq * s;
                m[other] = rp * s + rq * c;
                axes[row] = ap * c - aq * s;
                axes[other] = ap * s + aq * c;
            }
        }
    }
    return axes;
}

Vec3d corner(const Mesh& mesh, std::uint32_t index) {
    return vec_cast<double>(mesh.vertices[index]);
}

Matrix second_moments(const Mesh& mesh) {
    Vec3d first{};
    double area = 0;
    Matrix moments{};
    const Vec3d centre = bounds(mesh).centre();
    for (const Triangle& t : mesh.triangles) {
        const Vec3d a = corner(mesh, t[0]) - centre, b = corner(mesh, t[1]) - centre,
                    c = corner(mesh, t[2]) - centre;
        const double size = length(cross(b - a, c - a));
        const Vec3d middle = (a + b + c) * (1.0 / 3);
        area += size;
        first = first + middle * size;
        for (const Vec3d p : {a, b, c, middle * 3})
            for (std::size_t i = 0; i < 3; ++i)
                moments[i] = moments[i] + p * (p[static_cast<int>(i)] * size / 12);
    }
    if (area > 0)
        for (std::size_t i = 0; i < 3; ++i)
            moments[i] = moments[i] - first * (first[static_cast<int>(i)] / area);
    return moments;
}

struct Flat {
    Vec3d sum;
    double area = 0;
};

/// Directions of the largest flat faces, opposite ones together.
std::vector<Vec3d> flat_directions(const Mesh& mesh) {
    std::vector<Flat> normals;
    for (const Triangle& t : mesh.triangles) {
        const Vec3d a = corner(mesh, t[0]);
        Vec3d n = cross(corner(mesh, t[1]) - a, corner(mesh, t[2]) - a);
        if (n.x < 0 || (n.x == 0 && (n.y < 0 || (n.y == 0 && n.z < 0)))) n = -n;
        if (const double size = length(n); size > 0) normals.push_back({n, size});
    }
    // Large triangles lead, so few groups hold most of the area of what is flat.
    const auto larger = [](const Flat& a, const Flat& b) { return a.area > b.area; };
    std::stable_sort(normals.begin(), normals.end(), larger);
    constexpr std::size_t kGroups = 48, kTriangles = 20000;
    if (normals.size() > kTriangles) normals.resize(kTriangles);
    std::vector<Flat> groups;
    std::vector<Vec3d> leads;
    for (const Flat& flat : normals) {
        const Vec3d n = flat.sum * (1 / flat.area);
        std::size_t group = 0;
        while (group < groups.size() && std::fabs(dot(leads[group], n)) < kSameFlat) ++group;
        if (group == groups.size()) {
            if (group == kGroups) continue;
            groups.push_back({});
            leads.push_back(n);
        }
        groups[group].sum = groups[group].sum + flat.sum * (dot(leads[group], n) < 0 ? -1.0 : 1.0);
        groups[group].area += flat.area;
    }
    std::stable_sort(groups.begin(), groups.end(), larger);
    std::vector<Vec3d> directions;
    for (const Flat& group : groups)
        if (directions.size() < kFlats) directions.push_back(group.sum * (1 / length(group.sum)));
    return directions;
}

/// All six ways to lay three square axes along x, y and z; other signs are half turns of these.
void add_frame(Vec3d a, Vec3d b, std::vector<Turn>& turns) {
    const std::array<Vec3d, 3> axes{a, b, cross(a, b)};
    constexpr std::array<std::array<std::size_t, 3>, 6> kWays{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}};
    for (std::size_t way = 0; way < kWays.size(); ++way) {
        const auto [x, y, z] = kWays[way];
        // Odd orders mirror, which a reversed axis takes back.
        turns.push_back(turn_of({{axes[x], axes[y], way < 3 ? axes[z] : -axes[z]}}));
    }
}

}  // namespace

std::vector<Turn> suggested_turns(const Mesh& mesh) {
    std::vector<Turn> turns;
    add_frame({1, 0, 0}, {0, 1, 0}, turns);
    const Matrix principal = principal_axes(second_moments(mesh));
    add_frame(principal[0], principal[1], turns);
    const std::vector<Vec3d> flats = flat_directions(mesh);
    for (std::size_t i = 0; i < flats.size(); ++i) {
        for (std::size_t j = i + 1; j < flats.size(); ++j) {
            if (std::fabs(dot(flats[i], flats[j])) > 0.02) continue;
            const Vec3d square = flats[j] - flats[i] * dot(flats[i], flats[j]);
            add_frame(flats[i], square * (1 / length(square)), turns);
        }
    }
    return turns;
}

}  // namespace snug
