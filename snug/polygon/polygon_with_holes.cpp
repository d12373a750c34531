#include "snug/polygon/polygon_with_holes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <utility>

#include "snug/polygon/ear_clipping.h"
#include "snug/polygon/polygon.h"

namespace snug {
namespace {

double orientation(const PolygonVertex& a, const PolygonVertex& b, const PolygonVertex& c) {
    return orientation(a.at, b.at, c.at);
}

std::vector<Vec2d> points_of(const VertexLoop& loop) {
    std::vector<Vec2d> points;
    points.reserve(loop.size());
    for (const PolygonVertex& corner : loop) points.push_back(corner.at);
    return points;
}

bool between(const PolygonVertex& a, const PolygonVertex& b, const PolygonVertex& p) {
    return std::min(a.at.x, b.at.x) <= p.at.x && p.at.x <= std::max(a.at.x, b.at.x) &&
           std::min(a.at.y, b.at.y) <= p.at.y && p.at.y <= std::max(a.at.y, b.at.y);
}

int sign(double value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// Whether two segments have a point in common that is not an end of both.
bool cross(const PolygonVertex& a, const PolygonVertex& b, const PolygonVertex& c, const PolygonVertex& d) {
    const int abc = sign(orientation(a, b, c)), abd = sign(orientation(a, b, d)),
              cda = sign(orientation(c, d, a)), cdb = sign(orientation(c, d, b));
    if (abc * abd < 0 && cda * cdb < 0) return true;
    const auto touches = [](int side, const PolygonVertex& from, const PolygonVertex& to,
                            const PolygonVertex& p) {
        return side == 0 && between(from, to, p) && from.at != p.at && to.at != p.at;
    };
    return touches(abc, a, b, c) || touches(abd, a, b, d) || touches(cda, c, d, a) || touches(cdb, c, d, b);
}

bool crosses(const VertexLoop& loop, const PolygonVertex& a, const PolygonVertex& b) {
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (cross(a, b, loop[i], loop[(i + 1) % loop.size()])) return true;
    return false;
}

/// Whether the way from corner i to p begins inside the loop.
bool begins_inside(const VertexLoop& loop, std::size_t i, const PolygonVertex& p) {
    const PolygonVertex &before = loop[(i + loop.size() - 1) % loop.size()], &at = loop[i],
                        &after = loop[(i + 1) % loop.size()];
    const bool left_of_after = orientation(at, after, p) > 0, left_of_before = orientation(before, at, p) > 0;
    return orientation(before, at, after) > 0 ? left_of_after && left_of_before
                                              : left_of_after || left_of_before;
}

/// Makes one loop of an outer one and a hole, joined by the shortest way that meets neither nor other holes;
/// false where others stand in every way.
bool join_hole(VertexLoop& outer, const VertexLoop& hole, const std::vector<const VertexLoop*>& others) {
    std::vector<std::pair<double, std::pair<std::size_t, std::size_t>>> ways;
    for (std::size_t h = 0; h < hole.size(); ++h)
        for (std::size_t i = 0; i < outer.size(); ++i) {
            const Vec2d way = hole[h].at - outer[i].at;
            ways.push_back({way.x * way.x + way.y * way.y, {h, i}});
        }
    std::sort(ways.begin(), ways.end());
    for (const auto& way : ways) {
        const std::size_t h = way.second.first, i = way.second.second;
        const PolygonVertex &from = outer[i], &to = hole[h];
        if (!begins_inside(outer, i, to) || crosses(outer, from, to) || crosses(hole, from, to)) continue;
        if (std::any_of(others.begin(), others.end(),
                        [&](const VertexLoop* other) { return crosses(*other, from, to); }))
            continue;
        VertexLoop bridge;
        for (std::size_t n = 0; n <= hole.size(); ++n) bridge.push_back(hole[(h + n) % hole.size()]);
        bridge.push_back(from);
        outer.insert(outer.begin() + static_cast<std::ptrdiff_t>(i) + 1, bridge.begin(), bridge.end());
        return true;
    }
    return false;
}

/// Joins holes until none is left: there is always one that no other hides.
void join_holes(VertexLoop& outer, std::vector<const VertexLoop*> holes) {
    for (std::size_t hidden = 0; hidden < holes.size();) {
        const VertexLoop* hole = holes.back();
        holes.pop_back();
        if (join_hole(outer, *hole, holes)) {
            hidden = 0;
        } else {
            holes.insert(holes.begin(), hole);
            ++hidden;
        }
    }
}

}  // namespace

void triangulate_polygons(const std::vector<VertexLoop>& loops, std::vector<Triangle>& triangles) {
    constexpr double kNone = -1;  // of its triangles may be flat: on the lattice every ear has an area
    std::vector<const VertexLoop*> holes;
    for (const VertexLoop& loop : loops)
        if (signed_area(points_of(loop)) < 0) holes.push_back(&loop);
    for (const VertexLoop& loop : loops) {
        const std::vector<Vec2d> outline = points_of(loop);
        if (signed_area(outline) <= 0) continue;
        std::vector<const VertexLoop*> own;
        for (const VertexLoop* hole : holes)
            if (contains(outline, hole->front().at)) own.push_back(hole);
        VertexLoop whole = loop;
        join_holes(whole, std::move(own));
        std::vector<std::array<std::size_t, 3>> ears;
        [[maybe_unused]] const bool whole_area = clip_ears(points_of(whole), kNone, ears);
        assert(whole_area);
        for (const auto& [a, b, c] : ears)
            triangles.push_back({whole[a].vertex, whole[b].vertex, whole[c].vertex});
    }
}

}  // namespace snug
