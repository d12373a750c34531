#include "tests/support/brute_force.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace snug::test {
namespace {

using Polygon = std::vector<Vec3d>;

/// Sutherland-Hodgman: keeps the part of a polygon where side(p) >= 0; side is linear.
Polygon clipped(const Polygon& polygon, const std::function<double(Vec3d)>& side) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d p = polygon[i], q = polygon[(i + 1) % polygon.size()];
        const double sp = side(p), sq = side(q);
        if (sp >= 0) kept.push_back(p);
        if ((sp > 0 && sq < 0) || (sp < 0 && sq > 0)) kept.push_back(p + (q - p) * (sp / (sp - sq)));
    }
    return kept;
}

}  // namespace

Blocks brute_force_cut(const std::vector<PlacedTriangle>& triangles, const DesignSpace& space,
                       Vec3d clearance, bool cut_on_touch, double touch) {
    const Vec3d e =
        (cut_on_touch ? clearance : clearance - Vec3d{0.01, 0.01, 0.01}) + Vec3d{touch, touch, touch};
    const auto start = [&](int axis, int i) { return i * space.block_mm[axis] - space.size()[axis] / 2; };
    Blocks blocks(space.blocks);
    for (int j = 0; j < space.blocks.y; ++j) {
        for (int k = 0; k < space.blocks.z; ++k) {
            const double y0 = start(1, j) - e.y, y1 = start(1, j + 1) + e.y;
            const double z0 = start(2, k) - e.z, z1 = start(2, k + 1) + e.z;
            double low = std::numeric_limits<double>::infinity(), high = -low;
            for (const auto& [a, b, c] : triangles) {
                Polygon polygon{a, b, c};
                polygon = clipped(polygon, [&](Vec3d p) { return p.y - y0; });
                polygon = clipped(polygon, [&](Vec3d p) { return y1 - p.y; });
                polygon = clipped(polygon, [&](Vec3d p) { return p.z - z0; });
                polygon = clipped(polygon, [&](Vec3d p) { return z1 - p.z; });
                for (const Vec3d& p : polygon) {
                    low = std::min(low, p.x);
                    high = std::max(high, p.x);
                }
            }
            if (low > high) continue;
            for (int i = 0; i < space.blocks.x; ++i)
                if (high + e.x >= start(0, i) && low - e.x <= start(0, i + 1)) blocks.set_cut(i, j, k);
        }
    }
    return blocks;
}

}  // namespace snug::test
