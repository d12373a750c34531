#include "snug/mesh/raw_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "snug/base/box.h"
#include "snug/base/text.h"

namespace snug {
namespace {

constexpr std::size_t kMostVertices = std::numeric_limits<std::uint32_t>::max() - 1;
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

bool usable(Vec3d p) {
    const auto one = [](double value) { return std::fabs(value) <= kGreatestCoordinate; };
    return one(p.x) && one(p.y) && one(p.z);
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

/// `noun` and `which` name a vertex that is wrong.
template <class T>
Result<Mesh> recentred(RawMeshOf<T> raw, const std::string& noun, const std::string& which) {
    Box3d box;
    for (std::size_t v = 0; v < raw.vertices.size(); ++v) {
        const Vec3d p = vec_cast<double>(raw.vertices[v]);
        if (!usable(p))
            return fail(ErrorKind::input, noun + " " + grouped(v + 1) + which +
                                              " has a coordinate that is not a number, "
                                              "or beyond 1e30: repair or export it again");
        box.include(p);
    }
    Mesh mesh;
    mesh.origin = origin_for(box);
    mesh.vertices = relative_to(mesh.origin, std::move(raw.vertices));
    mesh.triangles = std::move(raw.triangles);
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
    if (raw.triangles.empty() && raw.vertices.empty())
        return fail(ErrorKind::input, "there are no triangles in this file");
    if (raw.triangles.empty())
        return fail(ErrorKind::input,
                    "there are " + counted(raw.vertices.size(), "point", "points") +
                        " but no triangles: this is a point cloud; make a mesh of it first");
    if (raw.vertices.size() > kMostVertices)
        return fail(ErrorKind::input, "there are more than 2^32 - 2 vertices");
    drop_unused(raw);

    return recentred(std::move(raw), "vertex", " of those that triangles use");
}

template <class T>
Result<Mesh> finish_cloud(RawMeshOf<T> raw) {
    if (raw.vertices.empty()) return fail(ErrorKind::input, "there are no points in this file");
    if (raw.vertices.size() > kMostVertices)
        return fail(ErrorKind::input, "there are more than 2^32 - 2 points");
    return recentred(std::move(raw), "point", "");
}

template Result<Mesh> finish_cloud(RawMeshOf<float>);
template Result<Mesh> finish_cloud(RawMeshOf<double>);
template Result<Mesh> finish(RawMeshOf<float>);
template Result<Mesh> finish(RawMeshOf<double>);

}  // namespace snug
