#pragma once

#include "snug/base/message.h"
#include "snug/base/side.h"

namespace snug {

/// "on its back"
[[nodiscard]] inline Message fallen_on(Side side) {
    constexpr const char* kCodes[6] = {"fall.floor", "fall.roof", "fall.back",
                                       "fall.front", "fall.left", "fall.right"};
    return say(kCodes[side]);
}

}  // namespace snug
