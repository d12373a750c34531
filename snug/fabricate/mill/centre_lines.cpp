#include "snug/fabricate/mill/centre_lines.h"

#include <algorithm>
#include <cmath>

namespace snug {
namespace {

/// From a value to the range begin..end, 0 within.
double outside(double value, double begin, double end) {
    return std::max({begin - value, value - end, 0.0});
}

double cross(Vec2d a, Vec2d b) {
    return a.x * b.y - a.y * b.x;
}

/// The square of the distance from the segment to the point.
double square_distance(Vec2d from, Vec2d to, Vec2d point) {
    const Vec2d along = to - from, away = point - from;
    const double square = along.x * along.x + along.y * along.y;
    const double share =
        square > 0 ? std::clamp((along.x * away.x + along.y * away.y) / square, 0.0, 1.0) : 0.0;
    const Vec2d rest = away - along * share;
    return rest.x * rest.x + rest.y * rest.y;
}

/// Whether the segment comes nearer to the rectangle than `radius`.
bool comes_near(Vec2d from, Vec2d to, Vec2d low, Vec2d high, double radius) {
    const double limit = (radius - kCutterTouch) * (radius - kCutterTouch);
    for (const Vec2d end : {from, to}) {
        const double dx = outside(end.x, low.x, high.x), dy = outside(end.y, low.y, high.y);
        if (dx * dx + dy * dy < limit) return true;
    }
    const Vec2d corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
    for (const Vec2d corner : corners)
        if (square_distance(from, to, corner) < limit) return true;
    // Only a segment that goes right through has its ends and the corners far away.
    const Vec2d along = to - from;
    if (std::max(from.x, to.x) < low.x || std::min(from.x, to.x) > high.x || std::max(from.y, to.y) < low.y ||
        std::min(from.y, to.y) > high.y)
        return false;
    bool left = false, right = false;
    for (const Vec2d corner : corners) (cross(along, corner - from) > 0 ? left : right) = true;
    return left && right;
}

}  // namespace

CentreLines::CentreLines(const MillField& field, int level, double radius_mm)
    : field_(field),
      level_(level),
      radius_(radius_mm),
      x_{field.cell_mm.x, field.size_mm().x},
      y_{field.cell_mm.y, field.size_mm().y} {
    const int ny = field.height.ny(), nx = field.height.nz();
    rows_.resize(static_cast<std::size_t>(ny));
    columns_.resize(static_cast<std::size_t>(nx));
    const auto extend = [](std::vector<Run>& runs, int at) {
        if (!runs.empty() && runs.back().end == at)
            runs.back().end = at + 1;
        else
            runs.push_back({at, at + 1});
    };
    for (int row = 0; row < ny; ++row)
        for (int column = 0; column < nx; ++column)
            if (field.height(row, column) > level) {
                extend(rows_[static_cast<std::size_t>(row)], column);
                extend(columns_[static_cast<std::size_t>(column)], row);
            }
}

std::vector<Stretch> CentreLines::along(const Runs& runs, double at, const Axis& axis) const {
    const double across = &runs == &rows_ ? y_.cell : x_.cell;
    const int count = static_cast<int>(runs.size());
    const int first = std::max(0, static_cast<int>(std::floor((at - radius_) / across)) - 1);
    const int last = std::min(count - 1, static_cast<int>(std::floor((at + radius_) / across)) + 1);
    std::vector<Stretch> taken;
    for (int i = first; i <= last; ++i) {
        const double away = outside(at, i * across, (i + 1) * across);
        if (away >= radius_ - kCutterTouch) continue;
        const double reach = std::sqrt(radius_ * radius_ - away * away);
        for (const Run& run : runs[static_cast<std::size_t>(i)])
            taken.push_back({run.begin * axis.cell - reach, run.end * axis.cell + reach});
    }
    std::sort(taken.begin(), taken.end(), [](const Stretch& a, const Stretch& b) {
        return a.begin != b.begin ? a.begin < b.begin : a.end < b.end;
    });
    std::vector<Stretch> left;
    double from = -radius_;
    const double end = axis.length + radius_;
    for (const Stretch& stretch : taken) {
        if (stretch.begin >= from - kCutterTouch && from <= end)
            left.push_back({from, std::clamp(stretch.begin, from, end)});
        from = std::max(from, stretch.end);
    }
    if (from <= end + kCutterTouch) left.push_back({std::min(from, end), end});
    return left;
}

bool CentreLines::free(Vec2d from, Vec2d to) const {
    const Vec2d low{std::min(from.x, to.x), std::min(from.y, to.y)};
    const Vec2d high{std::max(from.x, to.x), std::max(from.y, to.y)};
    const double beyond = radius_ + kCutterTouch;
    if (std::min(low.x, low.y) < -beyond || high.x > x_.length + beyond || high.y > y_.length + beyond)
        return false;
    const int first = std::max(0, static_cast<int>(std::floor((low.y - radius_) / y_.cell)));
    const int last = std::min(static_cast<int>(rows_.size()) - 1,
                              static_cast<int>(std::floor((high.y + radius_) / y_.cell)));
    for (int row = first; row <= last; ++row)
        for (const Run& run : rows_[static_cast<std::size_t>(row)]) {
            const double left = run.begin * x_.cell, right = run.end * x_.cell;
            if (right < low.x - radius_ || left > high.x + radius_) continue;
            if (comes_near(from, to, {left, row * y_.cell}, {right, (row + 1) * y_.cell}, radius_))
                return false;
        }
    return true;
}

}  // namespace snug
