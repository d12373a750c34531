#include "snug/polygon/convex_hull.h"

#include <algorithm>

namespace snug {

double turn(Vec2d a, Vec2d b, Vec2d c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::vector<Vec2d> convex_hull(std::vector<Vec2d> points) {
    const auto less = [](Vec2d a, Vec2d b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
    const auto same = [](Vec2d a, Vec2d b) { return a.x == b.x && a.y == b.y; };
    std::sort(points.begin(), points.end(), less);
    points.erase(std::unique(points.begin(), points.end(), same), points.end());
    if (points.size() < 3) return points;
    std::vector<Vec2d> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t begin = hull.size();
        for (const Vec2d point : points) {
            while (hull.size() >= begin + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0)
                hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

}  // namespace snug
