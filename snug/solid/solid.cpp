#include "snug/solid/solid.h"

#include <algorithm>
#include <utility>

#include "snug/polygon/corners.h"
#include "snug/solid/run_solid.h"
#include "snug/solid/solid_faces.h"

namespace snug {
namespace {

using Heights = Grid<std::uint16_t>;

std::vector<Vec3f> positions(const SolidCorners& corners, const DesignSpace& space, bool from_above) {
    std::vector<Vec3f> vertices;
    vertices.reserve(corners.vertex_count());
    for (int J = 0; J <= space.blocks.y; ++J) {
        for (int K = 0; K <= space.blocks.z; ++K) {
            for (const SolidCorner& corner : corners.on_line(J, K)) {
                const int level = from_above ? space.blocks.x - corner.level : corner.level;
                const Vec3d position{space.face(0, level), space.face(1, J), space.face(2, K)};
                vertices.insert(vertices.end(), corner.doubled ? 2 : 1, vec_cast<float>(position));
            }
        }
    }
    return vertices;
}

Solid solid(const Heights& heights, const DesignSpace& space, bool from_above) {
    const SolidCorners corners(heights);
    Solid result{positions(corners, space, from_above), {}};
    add_faces(heights, corners, {}, result.triangles);
    if (from_above)
        for (Triangle& t : result.triangles) std::swap(t[1], t[2]);
    return result;
}

/// Whether some column is kept but does not begin at its own side of the space.
bool is_shortened(const Grid<Run>& kept) {
    return std::any_of(kept.begin(), kept.end(), [](Run run) { return run.first > 0; });
}

Solid half_solid(const FoamPair& foams, const DesignSpace& space, Half half) {
    const bool from_above = half == Half::lid;
    Grid<Run> kept = kept_runs(foams, half, space.blocks.x);
    if (!is_shortened(kept)) return solid(foams.heights(half), space, from_above);
    if (from_above)
        for (Run& run : kept) run = from_other_end(run, space.blocks.x);
    return run_solid(kept, space);
}

}  // namespace

Solid lower_solid(const FoamPair& foams, const DesignSpace& space) {
    return half_solid(foams, space, Half::lower);
}
Solid upper_solid(const FoamPair& foams, const DesignSpace& space) {
    return half_solid(foams, space, Half::lid);
}

}  // namespace snug
