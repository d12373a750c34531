#pragma once

#include <string_view>

namespace snug {

/// The sides of the design space.
enum Side { kFloor, kRoof, kBack, kFront, kLeft, kRight };  // -x, +x, -y, +y, -z, +z
/// "floor", "roof", "back", "front", "left", "right"
[[nodiscard]] std::string_view side_name(Side side);

}  // namespace snug
