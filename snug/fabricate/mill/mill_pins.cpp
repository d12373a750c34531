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

/// Where the lower half has a place, from the lid's: near and far change.
Vec2d in_lid(Vec2d at, const MillField& lower) {
    return {at.x, lower.size_mm().y - at.y};
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

/// The place nearest to `goal` where both halves stand full.
std::optional<Vec2d> place_near(const MillField& lower, const MillField& lid, double radius, Vec2d goal) {
    const Vec2d size = lower.size_mm();
    std::optional<Vec2d> best;
    for (double y = radius; y <= size.y - radius; y += kRaster)
        for (double x = radius; x <= size.x - radius; x += kRaster) {
            const Vec2d at{x, y};
            if (best && length(at - goal) >= length(*best - goal)) continue;
            if (stands_full(lower, at, radius) && stands_full(lid, in_lid(at, lower), radius)) best = at;
        }
    return best;
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

MillPins mill_pins(const MillField& lower, const MillField& lid, double pin_mm, double flute_mm) {
    MillPins pins;
    const double depth =
        std::min({kDepth, flute_mm, lower.top_mm() - kLeastDepth, lid.top_mm() - kLeastDepth});
    const Vec2d size = lower.size_mm();
    const double radius = pin_mm / 2 + kAround;
    pins.no_room = true;
    if (depth < kLeastDepth) return pins;
    const auto first = place_near(lower, lid, radius, {0, size.y});
    if (!first) return pins;
    for (const double inwards : {2.0, 4.0, 8.0, 16.0}) {
        const auto second = place_near(lower, lid, radius, {size.x - inwards * pin_mm, 0});
        if (!second || length(*first - *second) < 4 * radius) continue;
        if (!fits_one_way(*first, *second, size, kApart * pin_mm)) continue;
        pins.no_room = false;
        for (const Vec2d at : {*first, *second}) {
            pins.halves[0].push_back({at, depth});
            pins.halves[1].push_back({in_lid(at, lower), depth});
        }
        return pins;
    }
    return pins;
}

}  // namespace snug
