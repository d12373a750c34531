#include "snug/search/direction_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace snug {
namespace {

constexpr std::size_t kSpins = 12;  // half a turn about x; the other half cuts the same
constexpr double kSpinDegrees = 180.0 / kSpins;
constexpr double kGoldenDegrees = 137.50776405003785;
constexpr std::size_t kAtOnce = 16;

/// Direction i of n on the half sphere z > 0 (a Fibonacci lattice: equal areas).
Vec3d spread_direction(std::size_t i, std::size_t n) {
    const double z = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    const double around = std::fmod(static_cast<double>(i) * kGoldenDegrees, 360.0);
    const Rotation turned = rotation_of(turn_about({0, 0, 1}, around));
    return turned(Vec3d{std::sqrt(1 - z * z), 0, z});
}

/// The smallest turn that takes a direction to +x.
Turn upright(Vec3d direction) {
    // Half of the angle between them lies along the sum of the two.
    const double length = std::sqrt(2 * (1 + direction.x));
    if (length < 1e-6) return {0, 0, 0, 1};
    return {length / 2, 0, direction.z / length, -direction.y / length};
}

}  // namespace

Result<std::vector<MappedDirection>> direction_map(const PlacementSearch& search, std::size_t directions,
                                                   const Progress& progress) {
    std::vector<MappedDirection> map;
    for (std::size_t begin = 0; begin < directions; begin += kAtOnce) {
        const std::size_t end = std::min(directions, begin + kAtOnce);
        std::vector<Turn> turns;
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t spin = 0; spin < kSpins; ++spin)
                turns.push_back(turn_about({1, 0, 0}, static_cast<double>(spin) * kSpinDegrees) *
                                upright(spread_direction(i, directions)));
        const auto found = search.glance(turns);
        for (std::size_t i = begin; i < end; ++i) {
            std::optional<FoundPlacement> best;
            for (std::size_t spin = 0; spin < kSpins; ++spin) {
                const auto& at = found[(i - begin) * kSpins + spin];
                if (at && (!best || at->cut_blocks < best->cut_blocks)) best = at;
            }
            if (best) map.push_back({spread_direction(i, directions), *best});
        }
        if (!go_on(progress, static_cast<double>(end) / static_cast<double>(directions)))
            return fail(ErrorKind::cancelled, "cancelled");
    }
    return map;
}

}  // namespace snug
