#include "snug/picture/outline.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace snug {
namespace {

constexpr int kSmoothings = 2;
constexpr std::size_t kFewestToSmooth = 12;  // smaller loops would shrink away

/// A loop as the middles of its cracks.
Loop crack_middles(const CellLoop& corners) {
    Loop loop;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const CellPoint from = corners[i], to = corners[i + 1 == corners.size() ? 0 : i + 1];
        const int steps = std::abs(to.x - from.x) + std::abs(to.y - from.y);
        const int dx = (to.x - from.x) / steps, dy = (to.y - from.y) / steps;
        for (int step = 0; step < steps; ++step)
            loop.push_back({from.x + (step + 0.5) * dx, from.y + (step + 0.5) * dy});
    }
    return loop;
}

Loop smoothed(const Loop& loop) {
    Loop result(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2d before = loop[i == 0 ? loop.size() - 1 : i - 1],
                    after = loop[i + 1 == loop.size() ? 0 : i + 1];
        result[i] = (before + after) * 0.25 + loop[i] * 0.5;
    }
    return result;
}

double squared_distance(Vec2d p, Vec2d a, Vec2d b) {
    const Vec2d ab = b - a, ap = p - a;
    const double along = ap.x * ab.x + ap.y * ab.y, all = ab.x * ab.x + ab.y * ab.y;
    const double share = all > 0 ? std::min(std::max(along / all, 0.0), 1.0) : 0;
    const Vec2d off = ap - ab * share;
    return off.x * off.x + off.y * off.y;
}

/// The point between `from` and `to` that lies farthest from the straight line between them.
std::pair<std::size_t, double> farthest(const Loop& line, std::size_t from, std::size_t to) {
    std::pair<std::size_t, double> found{from, -1};
    for (std::size_t i = from + 1; i < to; ++i) {
        const double distance = squared_distance(line[i], line[from], line[to]);
        if (distance > found.second) found = {i, distance};
    }
    return found;
}

}  // namespace

std::vector<Loop> outlines(const Mask& mask, double least_cells) {
    std::vector<Loop> loops;
    for (const CellLoop& corners : cell_loops(mask)) loops.push_back(crack_middles(corners));
    const auto area = [](const Loop& loop) { return std::fabs(signed_area(loop)); };
    double largest = 0;
    for (const Loop& loop : loops) largest = std::max(largest, area(loop));
    const double least = std::min(least_cells, largest);
    loops.erase(
        std::remove_if(loops.begin(), loops.end(), [&](const Loop& loop) { return area(loop) < least; }),
        loops.end());
    for (Loop& loop : loops)
        for (int pass = 0; pass < kSmoothings && loop.size() >= kFewestToSmooth; ++pass)
            loop = smoothed(loop);
    return loops;
}

Loop simplified(const Loop& loop, double tolerance) {
    if (loop.size() < 4) return loop;
    // Opened at the first point, with that point again at the end; the first cut finds the far side.
    Loop line = loop;
    line.push_back(loop.front());
    std::vector<char> kept(line.size(), 0);
    kept.front() = 1;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
    while (!open.empty()) {
        const auto range = open.back();
        open.pop_back();
        const auto cut = farthest(line, range.first, range.second);
        if (cut.second <= tolerance * tolerance) continue;
        kept[cut.first] = 1;
        open.push_back({range.first, cut.first});
        open.push_back({cut.first, range.second});
    }
    Loop result;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        if (kept[i]) result.push_back(line[i]);
    return result;
}

}  // namespace snug
