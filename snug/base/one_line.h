#pragma once

#include <string>
#include <string_view>

namespace snug {

/// The text as UTF-8 on one line, whatever its bytes are: a space for each line end or other control
/// character (C1 and Unicode's own line ends, too), nothing for marks that turn the direction of what
/// follows, U+FFFD for each byte that belongs to no character.
[[nodiscard]] std::string one_line(std::string_view text);

}  // namespace snug
