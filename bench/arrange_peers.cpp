#include "bench/arrange_peers.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <libnest2d/libnest2d.hpp>
#include <limits>
#include <utility>

#include "snug/polygon/cell_loops.h"

namespace snug::bench {
namespace {

constexpr libnest2d::Coord kCell = 1000000;  // of its lattice, a column's side

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
libnest2d::Item outline_of(const BitMask& own, MaskGap gap) {
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
        if (std::abs(area) > most) {
            most = std::abs(area);
            largest = loop;
            if (area > 0) std::reverse(largest.begin(), largest.end());
        }
    }
    ClipperLib::Path path;
    for (const CellPoint point : largest) path.emplace_back(point.x * kCell, point.y * kCell);
    path.push_back(path.front());
    return libnest2d::Item(std::move(path));
}

/// Whether it lays all pieces into a room. A tenth of a cell is left around, since what touches is refused.
bool nests(std::vector<libnest2d::Item> items, int rows, int columns, bool turned) {
    using namespace libnest2d;
    NestConfig<> config;
    config.placer_config.rotations = {0.0};
    if (turned) config.placer_config.rotations = {0.0, Pi / 2, Pi, 3 * Pi / 2};
    config.placer_config.parallel = false;
    const Box bin(columns * kCell + kCell / 10, rows * kCell + kCell / 10);
    return nest(items, bin, 0, config) == 1 &&
           std::all_of(items.begin(), items.end(), [](const Item& item) { return item.binId() == 0; });
}

std::vector<libnest2d::Item> outlines(const MaskProblem& problem) {
    std::vector<libnest2d::Item> items;
    for (const MaskPiece& piece : problem.pieces)
        items.push_back(outline_of(least_mask(problem, piece), problem.gap));
    return items;
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

std::optional<long long> nested_price(const MaskProblem& problem, const RoomTask& task, long long most,
                                      double seconds) {
    const auto items = outlines(problem);
    std::optional<long long> best;
    const auto begun = Clock::now();
    std::vector<std::pair<long long, std::pair<int, int>>> rooms;
    for (int rows = 1; rows <= task.most_rows; ++rows)
        for (int columns = 1; columns <= task.most_columns; ++columns)
            if (const long long price = task.price(rows, columns); price <= most && columns <= 3 * rows &&
                                                                   rows <= 3 * columns &&
                                                                   price >= least_price(problem, task))
                rooms.push_back({price, {rows, columns}});
    std::sort(rooms.begin(), rooms.end());
    // It goes into larger rooms more often: half the distance at a time, then one after the other.
    std::size_t low = 0, high = rooms.size();
    while (low < high && seconds_since(begun) < seconds) {
        const std::size_t middle = (low + high) / 2;
        bool any = false;
        for (std::size_t i = middle; i < std::min(high, middle + 6) && !any; ++i) {
            any = nests(items, rooms[i].second.first + problem.gap.rows,
                        rooms[i].second.second + problem.gap.columns, true);
            if (any) best = std::min(best.value_or(rooms[i].first), rooms[i].first);
        }
        any ? high = middle : low = middle + 1;
    }
    return best;
}

std::optional<double> nested_strip(const std::vector<std::vector<Vec2d>>& polygons, double height,
                                   double most, bool half_turns, double seconds) {
    using namespace libnest2d;
    const double scale = 1e8 / most;
    std::vector<Item> items;
    for (const auto& polygon : polygons) {
        ClipperLib::Path path;
        for (const Vec2d point : polygon)
            path.emplace_back(std::llround(point.x * scale), std::llround(point.y * scale));
        if (ClipperLib::Orientation(path)) std::reverse(path.begin(), path.end());
        path.push_back(path.front());
        items.emplace_back(std::move(path));
    }
    const auto holds = [&](double length) {
        NestConfig<> config;
        config.placer_config.rotations = {0.0};
        if (half_turns) config.placer_config.rotations = {0.0, Pi};
        config.placer_config.parallel = false;
        std::vector<Item> laid = items;
        const Box bin(std::llround(length * scale), std::llround(height * scale));
        return nest(laid, bin, 0, config) == 1 &&
               std::all_of(laid.begin(), laid.end(), [](const Item& item) { return item.binId() == 0; });
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
