#include "snug/fabricate/outline.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace snug {
namespace {

constexpr int kSmoothings = 2;
constexpr std::size_t kFewestToSmooth = 12;  // smaller loops would shrink away

/// Walks along the cracks between inside and outside cells, the inside on its right-hand side.
class Tracer {
  public:
    explicit Tracer(const Mask& mask)
        : mask_(mask),
          begun_(static_cast<std::size_t>(mask.width) * static_cast<std::size_t>(mask.height), 0) {}

    std::vector<Loop> trace() {
        std::vector<Loop> loops;
        // Every loop, around cells or around a hole, passes above some cell from left to right.
        for (int row = 0; row < mask_.height; ++row)
            for (int column = 0; column < mask_.width; ++column)
                if (mask_.inside(column, row) && !mask_.inside(column, row - 1) && !begun(column, row))
                    loops.push_back(follow(column, row));
        return loops;
    }

  private:
    char& begun(int column, int row) {
        return begun_[static_cast<std::size_t>(row) * static_cast<std::size_t>(mask_.width) +
                      static_cast<std::size_t>(column)];
    }

    /// The loop that begins at a cell's upper left corner, as the middles of its cracks.
    Loop follow(int first_column, int first_row) {
        Loop loop;
        int x = first_column, y = first_row, dx = 1, dy = 0;
        do {
            if (dx == 1) begun(x, y) = 1;
            loop.push_back({x + 0.5 * dx, y + 0.5 * dy});
            x += dx;
            y += dy;
            // The cells ahead lie around the corner (x, y): to the left (dy, -dx), to the right (-dy, dx).
            const bool left = mask_.inside(x + (dx + dy - 1) / 2, y + (dy - dx - 1) / 2);
            const bool right = mask_.inside(x + (dx - dy - 1) / 2, y + (dy + dx - 1) / 2);
            if (left)
                std::tie(dx, dy) = std::pair(dy, -dx);
            else if (!right)
                std::tie(dx, dy) = std::pair(-dy, dx);
        } while (x != first_column || y != first_row || dx != 1 || dy != 0);
        return loop;
    }

    const Mask& mask_;
    std::vector<char> begun_;
};

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

double signed_area(const Loop& loop) {
    double doubled = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2d a = loop[i], b = loop[i + 1 == loop.size() ? 0 : i + 1];
        doubled += a.x * b.y - a.y * b.x;
    }
    return 0.5 * doubled;
}

std::vector<Loop> outlines(const Mask& mask, double least_cells) {
    std::vector<Loop> loops = Tracer(mask).trace();
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
