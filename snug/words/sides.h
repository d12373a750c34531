#pragma once

#include "snug/base/message.h"
#include "snug/base/side.h"

namespace snug {

/// "floor", "roof", "back", "front", "left", "right"
[[nodiscard]] inline Message side_text(Side side) {
    constexpr const char* kCodes[6] = {"wall.floor", "wall.roof", "wall.back",
                                       "wall.front", "wall.left", "wall.right"};
    return say(kCodes[side]);
}

/// The side that a case falls on: "on its back"
[[nodiscard]] inline Message fallen_on(Side side) {
    constexpr const char* kCodes[6] = {"fall.floor", "fall.roof", "fall.back",
                                       "fall.front", "fall.left", "fall.right"};
    return say(kCodes[side]);
}

}  // namespace snug
