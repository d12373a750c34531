#include "snug/depth/cells.h"

#include <algorithm>
#include <limits>

namespace snug {

GrownCells::GrownCells(const DesignSpace& space, int axis, Reach reach)
    : start_(space.face(axis, 0)), count_(space.blocks[axis]), cells_per_mm_(1 / space.block_mm[axis]) {
    const int n = space.blocks[axis];
    low_.reserve(static_cast<std::size_t>(n));
    high_.reserve(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
        low_.push_back(space.face(axis, i) - reach.mm[axis]);
        high_.push_back(space.face(axis, i + 1) + reach.mm[axis]);
    }
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    sole_.reserve(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i)
        sole_.push_back({std::max(low(i), i > 0 ? high(i - 1) : -kInfinity),
                         std::min(high(i), i + 1 < n ? low(i + 1) : kInfinity)});
}

CellRange GrownCells::meeting(double a, double b) const {
    // The division only guesses; the stored bounds decide.
    const int n = count();
    const auto guess = [n](double cells) { return static_cast<int>(std::clamp(cells, 0.0, n - 1.0)); };
    int first = guess((a - high_.front()) * cells_per_mm_);
    while (first > 0 && high(first - 1) >= a) --first;
    while (first < n && high(first) < a) ++first;
    int last = guess((b - low_.front()) * cells_per_mm_);
    while (last + 1 < n && low(last + 1) <= b) ++last;
    while (last >= 0 && low(last) > b) --last;
    return {first, last};
}

}  // namespace snug
