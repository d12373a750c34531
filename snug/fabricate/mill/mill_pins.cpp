#include "snug/fabricate/mill/mill_pins.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace snug {
namespace {

constexpr double kAround = 3;      // mm of foam around a hole
constexpr double kDepth = 15;      // mm at most
constexpr double kLeastDepth = 4;  // mm that hold a pin
constexpr double kApart = 1.5;     // pins: as near as a turned half's holes may come
constexpr double kRaster = 2;      // mm between places that are tried

/// Where a place of the lower foam comes to lie on a side.
Vec2d on_side(Vec2d at, const PinnedSide& side) {
    return side.turned ? Vec2d{at.x, side.field.size_mm().y - at.y} : at;
}

/// The foam is as high as the stock within `radius` of the place.
bool stands_full(const MillField& field, Vec2d at, double radius) {
    const Vec2d size = field.size_mm();
    if (at.x < radius || at.y < radius || at.x > size.x - radius || at.y > size.y - radius) return false;
    const auto first = [](double mm, double cell) { return static_cast<int>(std::floor(mm / cell)); };
    for (int row = first(at.y - radius, field.cell_mm.y); row <= first(at.y + radius, field.cell_mm.y); ++row)
        for (int column = first(at.x - radius, field.cell_mm.x);
             column <= first(at.x + radius, field.cell_mm.x); ++column)
            if (field.height.contains(row, column) && field.height(row, column) < field.top) return false;
    return true;
}

/// The place nearest to `goal` where all sides stand full.
std::optional<Vec2d> place_near(std::span<const PinnedSide> sides, double radius, Vec2d goal) {
    const Vec2d size = sides.front().field.size_mm();
    std::optional<Vec2d> best;
    for (double y = radius; y <= size.y - radius; y += kRaster)
        for (double x = radius; x <= size.x - radius; x += kRaster) {
            const Vec2d at{x, y};
            if (best && length(at - goal) >= length(*best - goal)) continue;
            if (std::all_of(sides.begin(), sides.end(), [&](const PinnedSide& side) {
                    return stands_full(side.field, on_side(at, side), radius);
                }))
                best = at;
        }
    return best;
}

/// The deepest that holes may be everywhere, mm.
double depth_of(std::span<const PinnedSide> sides, double flute_mm) {
    double depth = std::min(kDepth, flute_mm);
    for (const PinnedSide& side : sides)
        depth = std::min(depth, (side.field.top_mm() - kLeastDepth) / (side.other_too ? 2 : 1));
    return depth;
}

/// Mirrored or turned by half, the two holes must not lie on the two pins again.
bool fits_one_way(Vec2d a, Vec2d b, Vec2d size, double least_apart) {
    for (const bool mirror_x : {false, true})
        for (const bool mirror_y : {false, true}) {
            if (!mirror_x && !mirror_y) continue;
            const auto mirrored = [&](Vec2d p) {
                return Vec2d{mirror_x ? size.x - p.x : p.x, mirror_y ? size.y - p.y : p.y};
            };
            const auto on_pin = [&](Vec2d p) { return std::min(length(p - a), length(p - b)) < least_apart; };
            if (on_pin(mirrored(a)) && on_pin(mirrored(b))) return false;
        }
    return true;
}

}  // namespace

MillPins mill_pins(std::span<const PinnedSide> sides, double pin_mm, double flute_mm) {
    MillPins pins{std::vector<std::vector<MillPin>>(sides.size()), true};
    const double depth = depth_of(sides, flute_mm);
    const Vec2d size = sides.front().field.size_mm();
    const double radius = pin_mm / 2 + kAround;
    if (depth < kLeastDepth) return pins;
    const auto first = place_near(sides, radius, {0, size.y});
    if (!first) return pins;
    for (const double inwards : {2.0, 4.0, 8.0, 16.0}) {
        const auto second = place_near(sides, radius, {size.x - inwards * pin_mm, 0});
        if (!second || length(*first - *second) < 4 * radius) continue;
        if (!fits_one_way(*first, *second, size, kApart * pin_mm)) continue;
        pins.no_room = false;
        for (std::size_t i = 0; i < sides.size(); ++i)
            for (const Vec2d at : {*first, *second}) pins.sides[i].push_back({on_side(at, sides[i]), depth});
        return pins;
    }
    return pins;
}

}  // namespace snug
