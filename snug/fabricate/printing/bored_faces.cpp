#include "snug/fabricate/printing/bored_faces.h"

#include <algorithm>

namespace snug {
namespace {

/// In the face's plane, seen from outside.
LoopPoint loop_point(const StepSolid& solid, std::uint32_t vertex, FaceSide side) {
    const Vec3i p = solid.points[vertex];
    if (side.axis == 0) return side.low ? LoopPoint{p.z, p.y, vertex} : LoopPoint{p.y, p.z, vertex};
    if (side.axis == 1) return {side.low ? -p.z : p.z, p.x, vertex};
    return {side.low ? p.y : -p.y, p.x, vertex};
}

/// The outlines of all that the edges go round, without those between two pieces of one face.
std::vector<PointLoop> loops_of(std::vector<std::pair<std::uint32_t, std::uint32_t>> edges,
                                const StepSolid& solid, FaceSide side) {
    std::sort(edges.begin(), edges.end());
    std::map<std::uint32_t, std::uint32_t> next;
    for (const auto& edge : edges)
        if (!std::binary_search(edges.begin(), edges.end(), std::pair{edge.second, edge.first}))
            next[edge.first] = edge.second;
    std::vector<PointLoop> loops;
    while (!next.empty()) {
        PointLoop loop;
        for (auto at = next.begin(); at != next.end();) {
            loop.push_back(loop_point(solid, at->first, side));
            const std::uint32_t to = at->second;
            next.erase(at);
            at = next.find(to);
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

std::int64_t twice_area(const PointLoop& loop) {
    std::int64_t area = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const LoopPoint &a = loop[i], &b = loop[(i + 1) % loop.size()];
        area += a.u * b.v - a.v * b.u;
    }
    return area;
}

/// The bore's wall and end; gives its mouth as a hole.
PointLoop add_bore(const SlabBore& bore, StepSolid& solid) {
    const auto count = static_cast<std::uint32_t>(bore.rim.size());
    const auto mouth = static_cast<std::uint32_t>(solid.points.size()), end = mouth + count;
    solid.points.insert(solid.points.end(), bore.rim.begin(), bore.rim.end());
    for (Vec3i p : bore.rim) {
        p[bore.side.axis] += bore.side.low ? bore.depth : -bore.depth;
        solid.points.push_back(p);
    }
    PointLoop rim;
    for (std::uint32_t i = 0; i < count; ++i) rim.push_back(loop_point(solid, mouth + i, bore.side));
    const bool forward = twice_area(rim) > 0;
    // Numbered counter-clockwise as seen from outside.
    const auto round = [&](std::uint32_t i) { return forward ? i % count : (2 * count - i) % count; };
    PointLoop hole;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t a = round(i), b = round(i + 1);
        solid.triangles.push_back({mouth + a, mouth + b, end + b});
        solid.triangles.push_back({mouth + a, end + b, end + a});
        if (i > 0 && i + 1 < count) solid.triangles.push_back({end + round(0), end + a, end + b});
        hole.push_back(rim[round(count - i)]);
    }
    return hole;
}

}  // namespace

bool BoredFaces::has(FaceSide side) const {
    return std::any_of(bores_.begin(), bores_.end(), [&](const SlabBore& bore) { return bore.side == side; });
}

void BoredFaces::add_edges(FaceSide side, const std::vector<std::uint32_t>& chain) {
    auto& edges = edges_[side];
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) edges.push_back({chain[i], chain[i + 1]});
}

void BoredFaces::add_to(StepSolid& solid) const {
    for (const auto& face : edges_) {
        std::vector<PointLoop> loops = loops_of(face.second, solid, face.first);
        for (const SlabBore& bore : bores_)
            if (bore.side == face.first) loops.push_back(add_bore(bore, solid));
        triangulate_loops(loops, solid.triangles);
    }
}

}  // namespace snug
