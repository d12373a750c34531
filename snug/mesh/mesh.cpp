#include "snug/mesh/mesh.h"

namespace snug {

Box3d bounds(const Mesh& mesh) {
    Box3d box;
    for (const Vec3f& v : mesh.vertices) box.include(vec_cast<double>(v));
    return box;
}

Mesh scaled(Mesh mesh, double factor) {
    if (factor == 1) return mesh;
    for (Vec3f& v : mesh.vertices) v = vec_cast<float>(vec_cast<double>(v) * factor);
    mesh.origin = mesh.origin * factor;
    return mesh;
}

}  // namespace snug
