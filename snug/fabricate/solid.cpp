#include "snug/fabricate/solid.h"

#include <algorithm>
#include <utility>

#include "snug/fabricate/corners.h"
#include "snug/fabricate/run_solid.h"
#include "snug/fabricate/solid_faces.h"

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
bool is_shortened(const Heights& missing) {
    return std::any_of(missing.begin(), missing.end(), [](std::uint16_t blocks) { return blocks > 0; });
}

Solid shortened_solid(const Heights& heights, const Heights& missing, const DesignSpace& space,
                      bool from_above) {
    Grid<CutRun> runs(heights.ny(), heights.nz());
    for (std::size_t column = 0; column < runs.size(); ++column) {
        const int from = missing[column], to = heights[column], nx = space.blocks.x;
        runs[column] = {static_cast<std::int16_t>(from_above ? nx - to : from),
                        static_cast<std::int16_t>(from_above ? nx - from : to)};
    }
    return run_solid(runs, space);
}

}  // namespace

Solid lower_solid(const FoamPair& foams, const DesignSpace& space) {
    if (is_shortened(foams.lower_missing))
        return shortened_solid(foams.lower, foams.lower_missing, space, false);
    return solid(foams.lower, space, false);
}
Solid upper_solid(const FoamPair& foams, const DesignSpace& space) {
    if (is_shortened(foams.upper_missing))
        return shortened_solid(foams.upper, foams.upper_missing, space, true);
    return solid(foams.upper, space, true);
}

}  // namespace snug
