#include "snug/depth/corner_crossings.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "snug/depth/depth_builder.h"

namespace snug {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Two numbers at a time: what every instruction set has.
using Pair [[gnu::vector_size(16)]] = double;
using Mask [[gnu::vector_size(16)]] = long long;

/// The points in which the triangle's edges cross two sides: for each none or two, by their order in the
/// triangle. `at` is the coordinate along the side.
struct Crossings {
    Mask crossed;
    Pair p_x, p_at, q_x, q_at;
};

inline Crossings crossings(const std::array<double, 3>& across, const std::array<double, 3>& along,
                           const std::array<double, 3>& x, Pair side, Mask& on_side) {
    std::array<Mask, 3> beyond;
    const Pair none{};
    for (std::size_t i = 0; i < 3; ++i) {
        beyond[i] = none + across[i] > side;
        on_side |= none + across[i] == side;
    }
    std::array<Pair, 3> edge_x, edge_at;
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = next_corner(a);
        const Pair t = (side - across[a]) / (across[b] - across[a]);
        edge_x[a] = x[a] + t * (x[b] - x[a]);
        edge_at[a] = along[a] + t * (along[b] - along[a]);
    }
    const Mask first = beyond[0] ^ beyond[1], last = beyond[2] ^ beyond[0];
    return {first | last, first ? edge_x[0] : edge_x[1], first ? edge_at[0] : edge_at[1],
            last ? edge_x[2] : edge_x[1], last ? edge_at[2] : edge_at[1]};
}

}  // namespace

bool extremes_beside_side(const std::array<double, 3>& u, const std::array<double, 3>& x,
                          const std::array<double, 2>& sides, std::array<DepthRange, 2>& found) {
    Mask on_side{};
    const Crossings at = crossings(u, u, x, Pair{sides[0], sides[1]}, on_side);
    if ((on_side[0] | on_side[1]) != 0) return false;
    const Pair low = at.p_x < at.q_x ? at.p_x : at.q_x, high = at.p_x < at.q_x ? at.q_x : at.p_x;
    for (std::size_t i = 0; i < 2; ++i)
        found[i] = at.crossed[i] != 0 ? DepthRange{low[i], high[i]} : DepthRange{};
    return true;
}

bool extremes_around_corner(const std::array<Vec3d, 3>& corners, const std::array<double, 4>& sides,
                            std::array<DepthRange, 4>& found) {
    const auto& [a, b, c] = corners;
    const std::array<double, 3> x{a.x, b.x, c.x}, y{a.y, b.y, c.y}, z{a.z, b.z, c.z};
    const Pair cell_side{sides[2], sides[3]};
    Mask on_side{};
    const Crossings rows = crossings(y, z, x, Pair{sides[0], sides[1]}, on_side);
    const Crossings cells = crossings(z, y, x, cell_side, on_side);
    if ((on_side[0] | on_side[1]) != 0) return false;

    const Pair none{};
    const Mask left{-1, 0};
    for (std::size_t row = 0; row < 2; ++row) {
        Pair low = none + kInfinity, high = none - kInfinity;
        if (rows.crossed[row] != 0) {
            // The section along the row's side, cut at the cells' sides.
            double start_x = rows.p_x[row], start_at = rows.p_at[row];
            double end_x = rows.q_x[row], end_at = rows.q_at[row];
            if (end_at < start_at || (end_at == start_at && end_x < start_x)) {
                std::swap(start_x, end_x);
                std::swap(start_at, end_at);
            }
            const double slope = end_at > start_at ? (end_x - start_x) / (end_at - start_at) : 0;
            const auto [lesser, greater] = std::minmax(start_x, end_x);
            const Pair inclined = start_x + (cell_side - start_at) * slope;
            const Pair raised = inclined < lesser ? none + lesser : inclined;
            const Pair corner = greater < raised ? none + greater : raised;
            const Mask cut = left ? cell_side < end_at : cell_side > start_at;
            const Mask seen =
                left ? cell_side >= start_at - kCrossingError : cell_side <= end_at + kCrossingError;
            const Pair one{start_x, end_x}, uncut{end_x, start_x};
            const Pair other = cut ? corner : uncut;
            low = seen ? (one < other ? one : other) : low;
            high = seen ? (one < other ? other : one) : high;
        }
        // And the edges that cross the cells' sides within the row.
        const double row_side = sides[row];
        for (const bool second : {false, true}) {
            const Pair at_x = second ? cells.q_x : cells.p_x, at_y = second ? cells.q_at : cells.p_at;
            const Mask within = cells.crossed & (row == 0 ? row_side >= at_y - kCrossingError
                                                          : row_side <= at_y + kCrossingError);
            low = (within & (at_x < low)) ? at_x : low;
            high = (within & (at_x > high)) ? at_x : high;
        }
        for (std::size_t cell = 0; cell < 2; ++cell) found[2 * row + cell] = {low[cell], high[cell]};
    }
    return true;
}

}  // namespace snug
