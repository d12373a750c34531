#include "snug/fabricate/carved_stock.h"

#include <algorithm>
#include <cmath>

namespace snug {
namespace {

constexpr double kTouch = 1e-7;  // mm
constexpr long long kMostCells = 8'000'000;

/// Half the length that the disc has at this distance from its middle.
double half_chord(double radius, double away) {
    return std::sqrt(std::max(0.0, radius * radius - away * away));
}

}  // namespace

CarvedStock::CarvedStock(const MillField& field, double radius_mm, double finest_mm) : radius_(radius_mm) {
    const long long cells = static_cast<long long>(field.height.size());
    for (double finest = finest_mm;; finest *= 1.25) {
        rows_ = std::max(1, static_cast<int>(std::ceil(field.cell_mm.y / finest - kTouch)));
        columns_ = std::max(1, static_cast<int>(std::ceil(field.cell_mm.x / finest - kTouch)));
        if (cells * rows_ * columns_ <= kMostCells || rows_ * columns_ == 1) break;
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
    const Vec2d along = line.to - line.from;
    const double length = snug::length(along);
    const auto stretch_at = [&](double y) {
        Stretch stretch{1, 0};
        const auto include = [&stretch](double begin, double end) {
            if (begin > end) return;
            if (stretch.begin > stretch.end)
                stretch = {begin, end};
            else
                stretch = {std::min(stretch.begin, begin), std::max(stretch.end, end)};
        };
        for (const Vec2d end : {line.from, line.to}) {
            const double away = std::abs(y - end.y);
            if (away <= radius_ + kTouch) {
                const double half = half_chord(radius_, away);
                include(end.x - half, end.x + half);
            }
        }
        if (length > 0) {  // the rectangle between the discs at its ends
            const Vec2d normal{-along.y / length * radius_, along.x / length * radius_};
            const Vec2d corners[] = {line.from + normal, line.to + normal, line.to - normal,
                                     line.from - normal};
            for (int i = 0; i < 4; ++i) {
                const Vec2d a = corners[i], b = corners[(i + 1) % 4];
                if ((a.y > y && b.y > y) || (a.y < y && b.y < y)) continue;
                const double share = a.y == b.y ? 0 : (y - a.y) / (b.y - a.y);
                const double x = a.x + share * (b.x - a.x);
                include(x, x);
                if (a.y == b.y) include(std::min(a.x, b.x), std::max(a.x, b.x));
            }
        }
        return stretch;
    };
    Stretch near = stretch_at(first * cell_.y);
    for (int row = first; row <= last; ++row) {
        const Stretch far = stretch_at((row + 1) * cell_.y);
        const double begin = std::max(near.begin, far.begin), end = std::min(near.end, far.end);
        const bool covered = near.begin <= near.end && far.begin <= far.end;
        near = far;
        if (!covered) continue;
        const int from = std::max(0, static_cast<int>(std::ceil((begin - kTouch) / cell_.x)));
        const int to = std::min(height_.nz(), static_cast<int>(std::floor((end + kTouch) / cell_.x)));
        for (int column = from; column < to; ++column)
            height_(row, column) = std::min(height_(row, column), level);
    }
}

}  // namespace snug
