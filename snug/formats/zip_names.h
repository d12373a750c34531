#pragma once

#include <string>
#include <string_view>

namespace snug {

/// A member's name as UTF-8 with slashes: taken as it is where it is UTF-8, otherwise from code page 437.
[[nodiscard]] std::string zip_name(std::string_view bytes);

}  // namespace snug
