#include "snug/space/placed_mesh.h"

#include <cstdint>

namespace snug {
namespace {

void append(Mesh& all, const Mesh& mesh, const Placement& placement) {
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    for (const Vec3f& vertex : mesh.vertices) all.vertices.push_back(vec_cast<float>(placement(vertex)));
    for (const Triangle& t : mesh.triangles)
        all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

}  // namespace

PlacedMesh::PlacedMesh(std::span<const Object> objects, const std::vector<Item>& items) {
    for (const Item& item : items) {
        whole_ = whole_ && objects[item.object].whole();
        closed_ = closed_ && objects[item.object].measure.watertight;
    }
    if (items.size() == 1) {
        only_ = &objects[items.front().object].mesh;
        placement_ = items.front().placement;
        return;
    }
    together_.emplace();
    for (const Item& item : items) append(*together_, objects[item.object].mesh, item.placement);
    placement_ = {rotation_from_euler({}), {}, bounds_of(items)};
}

std::deque<PlacedMesh> placed_layers(std::span<const Object> objects, const std::vector<Item>& items,
                                     int layers) {
    std::deque<PlacedMesh> meshes;
    for (int layer = 1; layer <= layers; ++layer) meshes.emplace_back(objects, of_layer(items, layer));
    return meshes;
}

}  // namespace snug
