#pragma once

#include <optional>
#include <string>

#include "snug/base/bytes.h"

namespace snug {

/// The text of a file in UTF-16 as UTF-8, as Windows programs write it: of either byte order, with a byte
/// order mark, or without one where the first letters leave no doubt that these are no numbers. None for any
/// other file.
[[nodiscard]] std::optional<std::string> utf8_of_utf16(Bytes file);

}  // namespace snug
