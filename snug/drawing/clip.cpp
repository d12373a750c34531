#include "snug/drawing/clip.h"

#include <algorithm>
#include <utility>

namespace snug {
namespace {

constexpr double kLeastPiece = 1e-6;  // mm, shorter ones are the edge of a neighbour

/// How far a point lies within one of the window's four sides, negative outside.
double within(Vec2d p, const Window& window, int side) {
    switch (side) {
        case 0:
            return p.x - window.min.x;
        case 1:
            return window.max.x - p.x;
        case 2:
            return p.y - window.min.y;
        default:
            return window.max.y - p.y;
    }
}

Vec2d between(Vec2d a, Vec2d b, double share) {
    return a + (b - a) * share;
}

/// The part of a straight line within the window, as shares of its length (Liang and Barsky, 1984).
std::optional<std::pair<double, double>> part_within(Vec2d a, Vec2d b, const Window& window) {
    double from = 0, to = 1;
    for (int side = 0; side < 4; ++side) {
        const double at_a = within(a, window, side), at_b = within(b, window, side);
        if (at_a < 0 && at_b < 0) return {};
        if (at_a < 0) from = std::max(from, at_a / (at_a - at_b));
        if (at_b < 0) to = std::min(to, at_a / (at_a - at_b));
    }
    if (to < from || length(b - a) * (to - from) < kLeastPiece) return {};
    return std::pair(from, to);
}

}  // namespace

std::vector<Vec2d> clipped_loop(const std::vector<Vec2d>& loop, const Window& window) {
    std::vector<Vec2d> inside = loop;
    for (int side = 0; side < 4 && !inside.empty(); ++side) {
        const std::vector<Vec2d> before = std::exchange(inside, {});
        for (std::size_t i = 0; i < before.size(); ++i) {
            const Vec2d a = before[i], b = before[i + 1 == before.size() ? 0 : i + 1];
            const double at_a = within(a, window, side), at_b = within(b, window, side);
            if (at_a >= 0) inside.push_back(a);
            if ((at_a < 0) != (at_b < 0)) inside.push_back(between(a, b, at_a / (at_a - at_b)));
        }
    }
    double doubled_area = 0;
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const Vec2d a = inside[i], b = inside[i + 1 == inside.size() ? 0 : i + 1];
        doubled_area += a.x * b.y - a.y * b.x;
    }
    if (std::max(doubled_area, -doubled_area) < kLeastPiece) inside.clear();
    return inside;
}

std::vector<std::vector<Vec2d>> clipped_line(const std::vector<Vec2d>& line, const Window& window) {
    std::vector<std::vector<Vec2d>> parts;
    bool joined = false;  // to the last part
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const auto part = part_within(line[i], line[i + 1], window);
        if (!part) {
            joined = false;
            continue;
        }
        if (!joined || part->first > 0) parts.push_back({between(line[i], line[i + 1], part->first)});
        parts.back().push_back(between(line[i], line[i + 1], part->second));
        joined = part->second >= 1;
    }
    return parts;
}

}  // namespace snug
