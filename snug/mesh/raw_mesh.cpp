#include "snug/mesh/raw_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "snug/base/box.h"
#include "snug/base/text.h"

namespace snug {
namespace {

constexpr std::size_t kMostRawVertices = std::numeric_limits<std::uint32_t>::max() - 1;
constexpr double kFarAway = 4;  // times the longest side: from there on floats would lose detail

/// Numbers the vertices that triangles use in the order of the file and drops the others.
template <class T>
void drop_unused(RawMeshOf<T>& raw) {
    std::vector<std::uint8_t> used(raw.vertices.size(), 0);
    for (const Triangle& triangle : raw.triangles)
        for (const std::uint32_t v : triangle) used[v] = 1;
    if (std::find(used.begin(), used.end(), 0) == used.end()) return;
    std::vector<std::uint32_t> number(used.size());
    std::uint32_t count = 0;
    for (std::size_t v = 0; v < used.size(); ++v) {
        if (used[v] == 0) continue;
        raw.vertices[count] = raw.vertices[v];
        number[v] = count++;
    }
    raw.vertices.resize(count);
    for (Triangle& triangle : raw.triangles)
        for (std::uint32_t& v : triangle) v = number[v];
}

/// None where a vertex is not usable.
template <class T>
std::optional<Box3d> box_of(const std::vector<Vec3<T>>& vertices) {
    Box3d box;
    for (const Vec3<T>& v : vertices) {
        const Vec3d p = vec_cast<double>(v);
        if (!usable(p)) return {};
        box.include(p);
    }
    return box;
}

template <class T>
void leave_out_triangles(RawMeshOf<T>& raw) {
    const auto wrong = [&](const Triangle& triangle) {
        return std::any_of(triangle.begin(), triangle.end(),
                           [&](std::uint32_t v) { return !usable(raw.vertices[v]); });
    };
    raw.read.left_out_faces += std::erase_if(raw.triangles, wrong);
    drop_unused(raw);
}

template <class T>
void leave_out_points(RawMeshOf<T>& raw) {
    raw.read.left_out_points += std::erase_if(raw.vertices, [](Vec3<T> p) { return !usable(p); });
}

std::vector<Vec3f> relative_to(Vec3d origin, std::vector<Vec3d> vertices) {
    std::vector<Vec3f> moved;
    moved.reserve(vertices.size());
    for (const Vec3d& p : vertices) moved.push_back(vec_cast<float>(p - origin));
    return moved;
}

std::vector<Vec3f> relative_to(Vec3d origin, std::vector<Vec3f> vertices) {
    if (origin == Vec3d{}) return vertices;
    for (Vec3f& p : vertices) p = vec_cast<float>(vec_cast<double>(p) - origin);
    return vertices;
}

template <class T>
Mesh recentred(RawMeshOf<T> raw, const Box3d& box) {
    Mesh mesh;
    mesh.origin = origin_for(box);
    mesh.vertices = relative_to(mesh.origin, std::move(raw.vertices));
    mesh.triangles = std::move(raw.triangles);
    mesh.read = raw.read;
    return mesh;
}

}  // namespace

Vec3d origin_for(const Box3d& box) {
    const Vec3d centre = box.centre();
    const double far = kFarAway * box.longest_side();
    const bool near = std::fabs(centre.x) <= far && std::fabs(centre.y) <= far && std::fabs(centre.z) <= far;
    return near ? Vec3d{} : centre;
}

template <class T>
Result<Mesh> finish(RawMeshOf<T> raw) {
    if (raw.read.faces == 0) raw.read.faces = raw.triangles.size() + raw.read.left_out_faces;
    if (raw.read.faces == 0 && raw.vertices.empty()) return fail(ErrorKind::input, say("mesh.no_triangles"));
    if (raw.read.faces == 0)
        return fail(ErrorKind::input, say("mesh.cloud", {{"points", raw.vertices.size()}}));
    if (raw.vertices.size() > kMostRawVertices) return fail(ErrorKind::input, say("mesh.too_many_vertices"));
    drop_unused(raw);
    auto box = box_of(raw.vertices);
    if (!box) {
        leave_out_triangles(raw);
        box = box_of(raw.vertices);
    }
    if (auto error = too_much_left_out(raw.read)) return tl::unexpected(std::move(*error));
    if (raw.triangles.empty()) return fail(ErrorKind::input, say("mesh.no_triangles"));
    return recentred(std::move(raw), *box);
}

template <class T>
Result<Mesh> finish_cloud(RawMeshOf<T> raw) {
    if (raw.vertices.empty()) return fail(ErrorKind::input, say("cloud.no_points"));
    if (raw.vertices.size() > kMostRawVertices) return fail(ErrorKind::input, say("cloud.too_many"));
    const std::size_t points = raw.vertices.size();
    auto box = box_of(raw.vertices);
    if (!box) {
        leave_out_points(raw);
        box = box_of(raw.vertices);
    }
    if (auto error = too_much_left_out(raw.read, points)) return tl::unexpected(std::move(*error));
    return recentred(std::move(raw), *box);
}

template Result<Mesh> finish_cloud(RawMeshOf<float>);
template Result<Mesh> finish_cloud(RawMeshOf<double>);
template Result<Mesh> finish(RawMeshOf<float>);
template Result<Mesh> finish(RawMeshOf<double>);

}  // namespace snug
