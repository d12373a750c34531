#include "snug/base/side.h"

namespace snug {

std::string_view side_name(Side side) {
    constexpr std::string_view kNames[6] = {"floor", "roof", "back", "front", "left", "right"};
    return kNames[side];
}

}  // namespace snug
