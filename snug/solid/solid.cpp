#include "snug/solid/solid.h"

#include <utility>

#include "snug/solid/solid_faces.h"

namespace snug {

Solid solid_of(const Grid<Run>& runs, const DesignSpace& space, Half half) {
    const SolidCorners corners(runs);
    Solid solid;
    add_faces(runs, corners, solid.triangles);
    if (half == Half::lid)
        for (Triangle& t : solid.triangles) std::swap(t[1], t[2]);
    solid.vertices.reserve(corners.points().size());
    for (const Vec3i p : corners.points()) {
        const int level = half == Half::lid ? space.blocks.x - p.x : p.x;
        const Vec3d position{space.face(0, level), space.face(1, p.y), space.face(2, p.z)};
        solid.vertices.push_back(vec_cast<float>(position));
    }
    return solid;
}

Solid solid_of(const Foams& foams, Piece piece, const DesignSpace& space) {
    if (piece.highest()) return upper_solid(foams, space);
    return solid_of(foams.piece(piece), space, Half::lower);
}

Solid lower_solid(const Foams& foams, const DesignSpace& space) {
    return solid_of(foams.piece(Half::lower), space, Half::lower);
}
Solid upper_solid(const Foams& foams, const DesignSpace& space) {
    return solid_of(kept_runs(foams, Half::lid, space.blocks.x), space, Half::lid);
}

}  // namespace snug
