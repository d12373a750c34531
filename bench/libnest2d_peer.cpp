#include "bench/libnest2d_peer.h"

#include <algorithm>
#include <cmath>
#include <libnest2d/libnest2d.hpp>

namespace snug::bench {
namespace {

using Corner = std::pair<double, double>;

/// Clockwise, as libnest2d has it (Andrew's monotone chain). Of concave polygons it makes no-fit polygons
/// that let them lie in each other, which is why slicers, too, give it hulls.
PeerOutline hull_of(PeerOutline corners) {
    std::sort(corners.begin(), corners.end());
    PeerOutline hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t begun = hull.size();
        for (const Corner& c : corners) {
            while (hull.size() >= begun + 2) {
                const Corner a = hull[hull.size() - 2], b = hull.back();
                const double turn =
                    (b.first - a.first) * (c.second - a.second) - (b.second - a.second) * (c.first - a.first);
                if (turn < 0) break;
                hull.pop_back();
            }
            hull.push_back(c);
        }
        hull.pop_back();
        std::reverse(corners.begin(), corners.end());
    }
    return hull;
}

/// Whether all lie in one rectangle of this size and, but for rounding, not in each other.
bool lie_apart(const std::vector<libnest2d::Item>& items, libnest2d::Coord width, libnest2d::Coord height) {
    ClipperLib::Clipper clipper;
    double sum = 0;
    libnest2d::Coord low_x = 0, low_y = 0, high_x = 0, high_y = 0;
    bool any = false;
    for (const libnest2d::Item& item : items) {
        if (item.binId() != 0) return false;
        const ClipperLib::Path path = item.transformedShape().Contour;
        sum += std::fabs(ClipperLib::Area(path));
        clipper.AddPath(path, ClipperLib::ptSubject, true);
        for (const auto& point : path) {
            low_x = any ? std::min(low_x, point.X) : point.X;
            low_y = any ? std::min(low_y, point.Y) : point.Y;
            high_x = any ? std::max(high_x, point.X) : point.X;
            high_y = any ? std::max(high_y, point.Y) : point.Y;
            any = true;
        }
    }
    ClipperLib::Paths together;
    clipper.Execute(ClipperLib::ctUnion, together, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    double area = 0;
    for (const auto& path : together) area += ClipperLib::Area(path);
    return high_x - low_x <= width && high_y - low_y <= height && std::fabs(area) >= sum * (1 - 1e-3);
}

}  // namespace

bool libnest2d_holds(const std::vector<PeerOutline>& outlines, double width, double height, int turns) {
    using namespace libnest2d;
    const double scale = 1e8 / std::max(width, height);
    const auto whole = [&](double length) { return static_cast<Coord>(std::llround(length * scale)); };
    std::vector<Item> items;
    for (const PeerOutline& outline : outlines) {
        ClipperLib::Path path;
        for (const auto& [x, y] : hull_of(outline)) path.emplace_back(whole(x), whole(y));
        path.push_back(path.front());
        items.emplace_back(std::move(path));
    }
    NestConfig<> config;
    config.placer_config.rotations.clear();
    for (int i = 0; i < turns; ++i) config.placer_config.rotations.push_back(2 * Pi * i / turns);
    config.placer_config.parallel = false;
    // A little more than the rectangle: what is laid edge to edge is refused otherwise.
    const Box bin(whole(width) + 1000, whole(height) + 1000);
    return nest(items, bin, 0, config) == 1 && lie_apart(items, whole(width) + 2000, whole(height) + 2000);
}

}  // namespace snug::bench
