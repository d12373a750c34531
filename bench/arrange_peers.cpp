#include "bench/arrange_peers.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "snug/polygon/cell_loops.h"

#include "bench/libnest2d_peer.h"

namespace snug::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

/// The way of a piece that takes the fewest columns.
const BitMask& least_mask(const MaskProblem& problem, const MaskPiece& piece) {
    const BitMask* least = nullptr;
    for (const int shape : piece.shapes) {
        const BitMask& mask = problem.shapes[static_cast<std::size_t>(shape)].mask;
        if (!least || mask.count() < least->count()) least = &mask;
    }
    return *least;
}

/// The largest outline of a mask, grown so that the gap is kept where these do not meet.
PeerOutline outline_of(const BitMask& own, MaskGap gap) {
    const BitMask mask = grown(own, gap);
    Mask cells(mask.columns(), mask.rows());
    for (const MaskRun& run : runs_of(mask))
        for (int k = run.first; k < run.end; ++k) cells.set(k, run.row);
    CellLoop largest;
    double most = 0;
    for (const CellLoop& loop : cell_loops(cells)) {
        double area = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const CellPoint a = loop[i], b = loop[(i + 1) % loop.size()];
            area += 1.0 * a.x * b.y - 1.0 * b.x * a.y;
        }
        if (std::fabs(area) <= most) continue;
        most = std::fabs(area);
        largest = loop;
    }
    PeerOutline outline;
    for (const CellPoint point : largest) outline.push_back({1.0 * point.x, 1.0 * point.y});
    return outline;
}

std::vector<PeerOutline> outlines(const MaskProblem& problem) {
    std::vector<PeerOutline> all;
    for (const MaskPiece& piece : problem.pieces)
        all.push_back(outline_of(least_mask(problem, piece), problem.gap));
    return all;
}

}  // namespace

long long shelf_price(const MaskProblem& problem, const RoomTask& task) {
    struct Box {
        int rows, columns;
    };
    long long least = std::numeric_limits<long long>::max();
    for (int width = 1; width <= task.most_columns + problem.gap.columns; ++width) {
        std::vector<Box> boxes;
        bool fits = true;
        for (const MaskPiece& piece : problem.pieces) {
            std::optional<Box> best;  // the flattest that goes in
            for (const int shape : piece.shapes) {
                const BitMask& mask = problem.shapes[static_cast<std::size_t>(shape)].mask;
                const Box box{mask.rows() + problem.gap.rows, mask.columns() + problem.gap.columns};
                if (box.columns <= width && (!best || box.rows < best->rows)) best = box;
            }
            fits = fits && best;
            if (best) boxes.push_back(*best);
        }
        if (!fits) continue;
        std::stable_sort(boxes.begin(), boxes.end(), [](Box a, Box b) { return a.rows > b.rows; });
        int rows = 0, used = width, widest = 0;
        for (const Box box : boxes) {
            if (used + box.columns > width) {
                rows += box.rows;
                used = 0;
            }
            used += box.columns;
            widest = std::max(widest, used);
        }
        least = std::min(least, task.price(rows - problem.gap.rows, widest - problem.gap.columns));
    }
    return least;
}

std::optional<long long> nested_price(const MaskProblem& problem, const RoomTask& task, double seconds) {
    const auto items = outlines(problem);
    std::optional<long long> best;
    const auto begun = Clock::now();
    for (int rows = 1; rows <= task.most_rows && seconds_since(begun) < seconds; ++rows) {
        const auto holds = [&](int columns) {
            return libnest2d_holds(items, columns + problem.gap.columns, rows + problem.gap.rows, 4);
        };
        int low = 1, high = task.most_columns;
        // What costs more than the best is not looked at.
        while (high > low && best && task.price(rows, high) >= *best) --high;
        if (!may_hold(problem, {rows, high, task.heights, {}}) || !holds(high)) continue;
        while (low < high)
            if (const int middle = (low + high) / 2; holds(middle))
                high = middle;
            else
                low = middle + 1;
        best = std::min(best.value_or(task.price(rows, high)), task.price(rows, high));
    }
    return best;
}

std::optional<double> nested_strip(const std::vector<std::vector<Vec2d>>& polygons, double height,
                                   double most, bool half_turns, double seconds) {
    std::vector<PeerOutline> items;
    for (const auto& polygon : polygons) {
        PeerOutline outline;
        for (const Vec2d point : polygon) outline.push_back({point.x, point.y});
        items.push_back(std::move(outline));
    }
    const auto holds = [&](double length) {
        return libnest2d_holds(items, length, height, half_turns ? 2 : 1);
    };
    const auto begun = Clock::now();
    if (!holds(most)) return {};
    double low = most / 4, high = most;
    while (high - low > most / 1000 && seconds_since(begun) < seconds)
        if (const double middle = (low + high) / 2; holds(middle))
            high = middle;
        else
            low = middle;
    return high;
}

}  // namespace snug::bench
