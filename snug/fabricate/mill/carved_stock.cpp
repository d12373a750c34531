#include "snug/fabricate/mill/carved_stock.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "snug/fabricate/mill/disc_way.h"

namespace snug {
namespace {

constexpr long long kMostStockCells = 8'000'000;

}  // namespace

CarvedStock::CarvedStock(const MillField& field, double radius_mm, double finest_mm) : radius_(radius_mm) {
    const long long cells = static_cast<long long>(field.height.size());
    for (double finest = finest_mm;; finest *= 1.25) {
        rows_ = std::max(1, static_cast<int>(std::ceil(field.cell_mm.y / finest - kCutterTouch)));
        columns_ = std::max(1, static_cast<int>(std::ceil(field.cell_mm.x / finest - kCutterTouch)));
        if (cells * rows_ * columns_ <= kMostStockCells || rows_ * columns_ == 1) break;
    }
    cell_ = {field.cell_mm.x / columns_, field.cell_mm.y / rows_};
    height_ = Grid<int>(field.height.ny() * rows_, field.height.nz() * columns_, field.top);
}

void CarvedStock::cut(const CutLine& line, int level) {
    // A cell lies in the way of the disc if all of its corners do. For each row of cells the stretch that the
    // disc's way covers at the row's near and far side; what both have in common covers the row, since the
    // way is convex.
    const Vec2d low{std::min(line.from.x, line.to.x), std::min(line.from.y, line.to.y)};
    const Vec2d high{std::max(line.from.x, line.to.x), std::max(line.from.y, line.to.y)};
    const int first = std::max(0, static_cast<int>(std::floor((low.y - radius_) / cell_.y)));
    const int last = std::min(height_.ny() - 1, static_cast<int>(std::floor((high.y + radius_) / cell_.y)));
    std::optional<Stretch> near = stretch_of_way(line, radius_, first * cell_.y);
    for (int row = first; row <= last; ++row) {
        const std::optional<Stretch> far = stretch_of_way(line, radius_, (row + 1) * cell_.y);
        const std::optional<Stretch> before = std::exchange(near, far);
        if (!before || !far) continue;
        const double begin = std::max(before->begin, far->begin), end = std::min(before->end, far->end);
        const int from = std::max(0, static_cast<int>(std::ceil((begin - kCutterTouch) / cell_.x)));
        const int to = std::min(height_.nz(), static_cast<int>(std::floor((end + kCutterTouch) / cell_.x)));
        for (int column = from; column < to; ++column)
            height_(row, column) = std::min(height_(row, column), level);
    }
}

}  // namespace snug
