#include "snug/mesh/raw_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "snug/base/box.h"
#include "snug/base/text.h"

namespace snug {
namespace {

constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
constexpr double kGreatestCoordinate = 1e30;
constexpr double kFarAway = 4;  // times the longest side: from there on floats would lose detail

/// Numbers the vertices that triangles use in the order of the file and drops the others.
void drop_unused(RawMesh& raw) {
    std::vector<std::uint32_t> number(raw.vertices.size(), kUnused);
    for (const Triangle& triangle : raw.triangles)
        for (const std::uint32_t v : triangle) number[v] = 0;
    std::uint32_t used = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] == kUnused) continue;
        raw.vertices[used] = raw.vertices[v];
        number[v] = used++;
    }
    if (used == raw.vertices.size()) return;
    raw.vertices.resize(used);
    for (Triangle& triangle : raw.triangles)
        for (std::uint32_t& v : triangle) v = number[v];
}

bool usable(Vec3d p) {
    const auto one = [](double value) { return std::fabs(value) <= kGreatestCoordinate; };
    return one(p.x) && one(p.y) && one(p.z);
}

/// Zero, so that the file's own floats stay as they are, unless the object lies so far away that they would
/// not.
Vec3d origin_for(const Box3d& box) {
    const Vec3d centre = box.centre();
    const double far = kFarAway * box.longest_side();
    const bool near = std::fabs(centre.x) <= far && std::fabs(centre.y) <= far && std::fabs(centre.z) <= far;
    return near ? Vec3d{} : centre;
}

}  // namespace

Result<Mesh> finish(RawMesh raw) {
    if (raw.triangles.empty() && raw.vertices.empty())
        return fail(ErrorKind::input, "there are no triangles in this file");
    if (raw.triangles.empty())
        return fail(ErrorKind::input,
                    "there are " + counted(raw.vertices.size(), "point", "points") +
                        " but no triangles: this is a point cloud; make a mesh of it first");
    if (raw.vertices.size() >= kUnused)
        return fail(ErrorKind::input, "there are more than 2^32 - 2 vertices");
    drop_unused(raw);

    Box3d box;
    for (std::size_t v = 0; v < raw.vertices.size(); ++v) {
        if (!usable(raw.vertices[v]))
            return fail(ErrorKind::input,
                        "vertex " + grouped(v + 1) +
                            " of those that triangles use has a coordinate that is not a number, "
                            "or beyond 1e30: repair or export the mesh again");
        box.include(raw.vertices[v]);
    }
    Mesh mesh;
    mesh.origin = origin_for(box);
    mesh.vertices.reserve(raw.vertices.size());
    for (const Vec3d& p : raw.vertices) mesh.vertices.push_back(vec_cast<float>(p - mesh.origin));
    mesh.triangles = std::move(raw.triangles);
    return mesh;
}

}  // namespace snug
