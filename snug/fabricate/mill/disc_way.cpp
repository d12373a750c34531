#include "snug/fabricate/mill/disc_way.h"

#include <algorithm>
#include <cmath>

namespace snug {
namespace {

/// Half the length that the disc has at this distance from its middle.
double half_chord(double radius, double away) {
    return std::sqrt(std::max(0.0, radius * radius - away * away));
}

void include(std::optional<Stretch>& stretch, double begin, double end) {
    if (!stretch)
        stretch = Stretch{begin, end};
    else
        stretch = Stretch{std::min(stretch->begin, begin), std::max(stretch->end, end)};
}

}  // namespace

std::optional<Stretch> stretch_of_way(const CutLine& line, double radius, double y) {
    std::optional<Stretch> stretch;
    for (const Vec2d end : {line.from, line.to}) {
        const double away = std::abs(y - end.y);
        if (away > radius + kCutterTouch) continue;
        const double half = half_chord(radius, away);
        include(stretch, end.x - half, end.x + half);
    }
    const Vec2d along = line.to - line.from;
    const double long_mm = length(along);
    if (long_mm <= 0) return stretch;
    // The rectangle between the discs at its ends.
    const Vec2d normal{-along.y / long_mm * radius, along.x / long_mm * radius};
    const Vec2d corners[] = {line.from + normal, line.to + normal, line.to - normal, line.from - normal};
    for (int i = 0; i < 4; ++i) {
        const Vec2d a = corners[i], b = corners[(i + 1) % 4];
        if ((a.y > y && b.y > y) || (a.y < y && b.y < y)) continue;
        const double share = a.y == b.y ? 0 : (y - a.y) / (b.y - a.y);
        const double x = a.x + share * (b.x - a.x);
        include(stretch, x, x);
        if (a.y == b.y) include(stretch, std::min(a.x, b.x), std::max(a.x, b.x));
    }
    return stretch;
}

}  // namespace snug
