#pragma once

#include "snug/base/half.h"
#include "snug/base/message.h"

namespace snug {

/// "lower foam", "lid"
[[nodiscard]] inline Message foam_of(Half half) {
    return half == Half::lower ? say("foam.lower") : say("foam.lid");
}

/// "lower half", "lid"
[[nodiscard]] inline Message half_of(Half half) {
    return half == Half::lower ? say("foam.lower_half") : say("foam.lid");
}

/// How pages call a half by what is written on it: "LOWER", "LID"
[[nodiscard]] inline Message marked_half(Half half) {
    return half == Half::lower ? say("mark.lower") : say("mark.lid");
}

}  // namespace snug
