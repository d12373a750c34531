#include "snug/polygon/holed_polygon.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace snug {
namespace {

using Signed = std::int64_t;

/// Twice the area of a triangle; above 0 where a, b, c turn counter-clockwise. Exact for planes of 16 m.
Signed turn(const LoopPoint& a, const LoopPoint& b, const LoopPoint& c) {
    return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

bool same_place(const LoopPoint& a, const LoopPoint& b) {
    return a.u == b.u && a.v == b.v;
}

Signed twice_area(const PointLoop& loop) {
    Signed area = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) area += turn(loop[0], loop[i], loop[(i + 1) % loop.size()]);
    return area;
}

bool inside(const PointLoop& loop, const LoopPoint& p) {
    bool in = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const LoopPoint &a = loop[i], &b = loop[(i + 1) % loop.size()];
        if ((a.v > p.v) != (b.v > p.v) && (turn(a, b, p) > 0) == (b.v > a.v)) in = !in;
    }
    return in;
}

bool between(const LoopPoint& a, const LoopPoint& b, const LoopPoint& p) {
    return std::min(a.u, b.u) <= p.u && p.u <= std::max(a.u, b.u) && std::min(a.v, b.v) <= p.v &&
           p.v <= std::max(a.v, b.v);
}

int sign(Signed value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// Whether two segments have a point in common that is not an end of both.
bool cross(const LoopPoint& a, const LoopPoint& b, const LoopPoint& c, const LoopPoint& d) {
    const int abc = sign(turn(a, b, c)), abd = sign(turn(a, b, d)), cda = sign(turn(c, d, a)),
              cdb = sign(turn(c, d, b));
    if (abc * abd < 0 && cda * cdb < 0) return true;
    const auto touches = [](int side, const LoopPoint& from, const LoopPoint& to, const LoopPoint& p) {
        return side == 0 && between(from, to, p) && !same_place(from, p) && !same_place(to, p);
    };
    return touches(abc, a, b, c) || touches(abd, a, b, d) || touches(cda, c, d, a) || touches(cdb, c, d, b);
}

bool crosses(const PointLoop& loop, const LoopPoint& a, const LoopPoint& b) {
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (cross(a, b, loop[i], loop[(i + 1) % loop.size()])) return true;
    return false;
}

/// Whether the way from corner i to p begins inside the loop.
bool begins_inside(const PointLoop& loop, std::size_t i, const LoopPoint& p) {
    const LoopPoint &before = loop[(i + loop.size() - 1) % loop.size()], &at = loop[i],
                    &after = loop[(i + 1) % loop.size()];
    const bool left_of_after = turn(at, after, p) > 0, left_of_before = turn(before, at, p) > 0;
    return turn(before, at, after) > 0 ? left_of_after && left_of_before : left_of_after || left_of_before;
}

/// Makes one loop of an outer one and a hole, joined by the shortest way that meets neither nor other holes;
/// false where others stand in every way.
bool join_hole(PointLoop& outer, const PointLoop& hole, const std::vector<const PointLoop*>& others) {
    std::vector<std::pair<Signed, std::pair<std::size_t, std::size_t>>> ways;
    for (std::size_t h = 0; h < hole.size(); ++h)
        for (std::size_t i = 0; i < outer.size(); ++i) {
            const Signed u = hole[h].u - outer[i].u, v = hole[h].v - outer[i].v;
            ways.push_back({u * u + v * v, {h, i}});
        }
    std::sort(ways.begin(), ways.end());
    for (const auto& way : ways) {
        const std::size_t h = way.second.first, i = way.second.second;
        const LoopPoint &from = outer[i], &to = hole[h];
        if (!begins_inside(outer, i, to) || crosses(outer, from, to) || crosses(hole, from, to)) continue;
        if (std::any_of(others.begin(), others.end(),
                        [&](const PointLoop* other) { return crosses(*other, from, to); }))
            continue;
        PointLoop bridge;
        for (std::size_t n = 0; n <= hole.size(); ++n) bridge.push_back(hole[(h + n) % hole.size()]);
        bridge.push_back(from);
        outer.insert(outer.begin() + static_cast<std::ptrdiff_t>(i) + 1, bridge.begin(), bridge.end());
        return true;
    }
    return false;
}

/// Joins holes until none is left: there is always one that no other hides.
void join_holes(PointLoop& outer, std::vector<const PointLoop*> holes) {
    for (std::size_t hidden = 0; hidden < holes.size();) {
        const PointLoop* hole = holes.back();
        holes.pop_back();
        if (join_hole(outer, *hole, holes)) {
            hidden = 0;
        } else {
            holes.insert(holes.begin(), hole);
            ++hidden;
        }
    }
}

/// Cuts off ears until nothing is left.
void clip_ears(PointLoop loop, std::vector<Triangle>& triangles) {
    const auto is_ear = [&](std::size_t i) {
        const std::size_t n = loop.size();
        const LoopPoint &a = loop[(i + n - 1) % n], &b = loop[i], &c = loop[(i + 1) % n];
        if (turn(a, b, c) <= 0) return false;
        return std::none_of(loop.begin(), loop.end(), [&](const LoopPoint& p) {
            if (same_place(p, a) || same_place(p, b) || same_place(p, c)) return false;
            return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
        });
    };
    std::size_t at = 0, missed = 0;
    while (loop.size() >= 3 && missed < loop.size()) {
        at %= loop.size();
        if (!is_ear(at)) {
            ++at;
            ++missed;
            continue;
        }
        const std::size_t n = loop.size();
        triangles.push_back({loop[(at + n - 1) % n].vertex, loop[at].vertex, loop[(at + 1) % n].vertex});
        loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(at));
        missed = 0;
    }
}

}  // namespace

void triangulate_loops(const std::vector<PointLoop>& loops, std::vector<Triangle>& triangles) {
    std::vector<const PointLoop*> holes;
    for (const PointLoop& loop : loops)
        if (twice_area(loop) < 0) holes.push_back(&loop);
    for (const PointLoop& loop : loops) {
        if (twice_area(loop) <= 0) continue;
        std::vector<const PointLoop*> own;
        for (const PointLoop* hole : holes)
            if (inside(loop, hole->front())) own.push_back(hole);
        PointLoop whole = loop;
        join_holes(whole, std::move(own));
        clip_ears(std::move(whole), triangles);
    }
}

}  // namespace snug
