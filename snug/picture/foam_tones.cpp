#include "snug/picture/foam_tones.h"

#include <algorithm>
#include <cmath>

#include "snug/drawing/svg.h"

namespace snug {
namespace {

constexpr int kDepthTones = 12;

/// The darkest tone of a foam: its own hue, richer, never grey.
Color deepened(Color foam) {
    const auto part = [](int value) { return static_cast<std::uint8_t>(value * value / 255 * 2 / 3); };
    return {part(foam.red), part(foam.green), part(foam.blue)};
}

}  // namespace

FoamTones::FoamTones(const Relief& relief, Color foam)
    : relief_(relief),
      tones_{mixed(foam, kWhite, 0.3), foam, mixed(foam, kBlack, 0.2)},
      deep_(deepened(foam)) {}

Color FoamTones::of(const Face& face) const {
    const Color color = tones_[static_cast<int>(face.side)];
    const bool outer = (face.side == FaceSide::front && face.origin.y == relief_.front_faces.back()) ||
                       (face.side == FaceSide::right && face.origin.x == relief_.right_faces.back());
    if (outer || relief_.bottom >= 0) return color;
    const double depth = (face.origin.z + 0.5 * face.along.z) / relief_.bottom;
    const double step = std::floor(std::min(std::max(depth, 0.0), 1.0) * kDepthTones + 0.5) / kDepthTones;
    return mixed(color, deep_, 0.75 * step);
}

}  // namespace snug
