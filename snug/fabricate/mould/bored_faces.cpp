#include "snug/fabricate/mould/bored_faces.h"

#include <algorithm>

#include "snug/polygon/lattice.h"
#include "snug/polygon/polygon.h"

namespace snug {
namespace {

/// In the face's plane, seen from outside.
PolygonVertex polygon_vertex(const StepSolid& solid, std::uint32_t vertex, BoredSide side) {
    const Vec3d p = vec_cast<double>(solid.points[vertex]);
    if (side.axis == 0)
        return side.low ? PolygonVertex{{p.z, p.y}, vertex} : PolygonVertex{{p.y, p.z}, vertex};
    if (side.axis == 1) return {{side.low ? -p.z : p.z, p.x}, vertex};
    return {{side.low ? p.y : -p.y, p.x}, vertex};
}

/// The outlines of all that the edges go round, without those between two pieces of one face.
std::vector<VertexLoop> loops_of(std::vector<std::pair<std::uint32_t, std::uint32_t>> edges,
                                 const StepSolid& solid, BoredSide side) {
    std::sort(edges.begin(), edges.end());
    std::map<std::uint32_t, std::uint32_t> next;
    for (const auto& edge : edges)
        if (!std::binary_search(edges.begin(), edges.end(), std::pair{edge.second, edge.first}))
            next[edge.first] = edge.second;
    std::vector<VertexLoop> loops;
    while (!next.empty()) {
        VertexLoop loop;
        for (auto at = next.begin(); at != next.end();) {
            loop.push_back(polygon_vertex(solid, at->first, side));
            const std::uint32_t to = at->second;
            next.erase(at);
            at = next.find(to);
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

/// The bore within its opening; gives the opening as a hole, clockwise as seen from outside.
VertexLoop add_bore(const SlabBore& bore, StepSolid& solid) {
    const auto opening = static_cast<std::uint32_t>(solid.points.size());
    const BoreVertices at{opening, opening + 4, opening + 4 + kBoreSides};
    solid.points.insert(solid.points.end(), bore.opening.begin(), bore.opening.end());
    solid.points.insert(solid.points.end(), bore.mouth.begin(), bore.mouth.end());
    for (Vec3i p : bore.mouth) {
        p[bore.side.axis] += bore.side.low ? bore.depth : -bore.depth;
        solid.points.push_back(p);
    }
    add_bore(at, bore.side.axis, bore.side.low, solid.triangles);
    VertexLoop hole;
    std::vector<Vec2d> outline;
    for (const std::uint32_t corner : {0u, 1u, 3u, 2u}) {
        hole.push_back(polygon_vertex(solid, opening + corner, bore.side));
        outline.push_back(hole.back().at);
    }
    if (signed_area(outline) > 0) std::reverse(hole.begin(), hole.end());
    return hole;
}

}  // namespace

SlabBore slab_bore(const Bore& bore, bool after, Vec3d from_mm, int plane, const PrintOptions& options) {
    const double radius = bore_corner_radius_mm(options);
    SlabBore result{{bore.axis, after}, static_cast<int>(in_steps(bore_depth_mm(options))), {}, {}};
    const Vec3d centre = bore.centre_mm - from_mm;
    const auto on_lattice = [&](Vec3d mm) {
        Vec3i steps;
        for (int axis = 0; axis < 3; ++axis) steps[axis] = static_cast<int>(in_steps(mm[axis]));
        steps[bore.axis] = plane;
        return steps;
    };
    for (const Vec3d corner : bore_ring(bore.axis, centre, radius))
        result.mouth.push_back(on_lattice(corner));
    const double half_side = radius + in_mm(1);  // rounding leaves the mouth inside
    const PlaneAxes axes = plane_axes(bore.axis);
    for (const double row : {-half_side, half_side})
        for (const double position : {-half_side, half_side}) {
            Vec3d corner = centre;
            corner[axes.row] += row;
            corner[axes.position] += position;
            result.opening.push_back(on_lattice(corner));
        }
    return result;
}

bool BoredFaces::has(BoredSide side) const {
    return std::any_of(bores_.begin(), bores_.end(), [&](const SlabBore& bore) { return bore.side == side; });
}

void BoredFaces::add_edges(BoredSide side, const std::vector<std::uint32_t>& chain) {
    auto& edges = edges_[side];
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) edges.push_back({chain[i], chain[i + 1]});
}

void BoredFaces::add_to(StepSolid& solid) const {
    for (const auto& face : edges_) {
        std::vector<VertexLoop> loops = loops_of(face.second, solid, face.first);
        for (const SlabBore& bore : bores_)
            if (bore.side == face.first) loops.push_back(add_bore(bore, solid));
        triangulate_polygons(loops, solid.triangles);
    }
}

}  // namespace snug
