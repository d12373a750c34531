#include "snug/check/wall_advice.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "snug/base/text.h"

namespace snug {
namespace {

constexpr double kTolerance = 1e-6;  // mm, of sums of block sizes
constexpr double kMostBlocks = 4096;

double blocks_over(double mm, double size) {
    return std::max(0.0, std::ceil((mm - kTolerance) / size));
}

std::string vector_text(Vec3d v) {
    return number(v.x, 4) + "," + number(v.y, 4) + "," + number(v.z, 4);
}

/// The smallest shift in whole blocks that gives both sides of an axis what they need; none where there is
/// not enough foam on the two together.
std::optional<double> shift_mm(double low, double high, double least_low, double least_high, double size) {
    const double blocks =
        least_low > low ? blocks_over(least_low - low, size) : -blocks_over(least_high - high, size);
    const double shift = blocks * size;
    if (low + shift < least_low - kTolerance || high - shift < least_high - kTolerance) return {};
    return shift;
}

/// A shift along every axis that lacks something.
std::optional<Vec3d> shift_of(const Walls& wall, const Walls& least, const DesignSpace& space) {
    Vec3d shift;
    for (int axis = 0; axis < 3; ++axis) {
        const auto low = static_cast<std::size_t>(2 * axis), high = low + 1;
        const auto own = shift_mm(wall[low], wall[high], least[low], least[high], space.block_mm[axis]);
        if (!own) return {};
        shift[axis] = *own;
    }
    return shift;
}

/// As many blocks more on both sides of an axis, so that the object meets the blocks as it does now.
std::optional<Vec3d> counts_of(const Walls& wall, const Walls& least, const DesignSpace& space) {
    Vec3d counts = vec_cast<double>(space.blocks);
    for (int axis = 0; axis < 3; ++axis) {
        const auto low = static_cast<std::size_t>(2 * axis), high = low + 1;
        const double lacking = std::max(least[low] - wall[low], least[high] - wall[high]);
        counts[axis] += 2 * blocks_over(lacking, space.block_mm[axis]);
        if (counts[axis] > kMostBlocks) return {};
    }
    return counts;
}

/// Length, width and height inside of a case of the same play that has the foam which is lacking on the sides
/// of each axis together.
std::string larger_case(const Walls& wall, const Walls& least, const DesignSpace& space,
                        const SpaceChoice& choice) {
    Vec3d inside = *choice.inside_mm;
    for (int axis = 0; axis < 3; ++axis) {
        const auto low = static_cast<std::size_t>(2 * axis), high = low + 1;
        const double size = space.block_mm[axis];
        inside[axis] +=
            2 * size * blocks_over(std::max(least[low] - wall[low], least[high] - wall[high]), size);
    }
    return dimensions({std::ceil(inside.z), std::ceil(inside.y), std::ceil(inside.x)}, 0);
}

std::string walls_text(const Walls& least) {
    const auto differs = [&](double mm) { return mm != least[0]; };
    if (std::none_of(least.begin(), least.end(), differs)) return number(least[0], 2);
    std::string text;
    for (const double mm : least) text += (text.empty() ? "" : ",") + number(mm, 2);
    return text;
}

}  // namespace

Message wall_advice(const Walls& wall_mm, const Walls& least_mm, const DesignSpace& space,
                    const SpaceChoice& choice) {
    Walls least = least_mm;
    if (choice.kind == SpaceChoice::Kind::fitted) {
        for (std::size_t i = 0; i < least.size(); ++i) least[i] = std::max(least[i], choice.wall_mm[i]);
        return say("advice.walls", {{"walls", walls_text(least)}});
    }
    if (choice.kind == SpaceChoice::Kind::shaped)
        return say("advice.move_or_case", {{"inside", larger_case(wall_mm, least, space, choice)}});
    if (const auto shift = shift_of(wall_mm, least, space))
        return say("advice.move", {{"offset", vector_text(choice.offset_mm + *shift)}});
    if (choice.kind == SpaceChoice::Kind::box)
        return say("advice.turn_or_case", {{"inside", larger_case(wall_mm, least, space, choice)}});
    if (const auto counts = counts_of(wall_mm, least, space))
        return say("advice.blocks", {{"blocks", number(counts->x, 0) + "x" + number(counts->y, 0) + "x" +
                                                    number(counts->z, 0)}});
    return say("advice.larger_blocks");
}

}  // namespace snug
