#pragma once

#include <cstddef>

#include "snug/base/bytes.h"
#include "snug/base/result.h"

namespace snug::cli {

/// Unpacks raw DEFLATE (RFC 1951). Fails (input) where it is damaged or holds more than `most` bytes; never
/// asks for much more memory than it fills.
[[nodiscard]] Result<FileBytes> inflate(Bytes packed, std::size_t most);

}  // namespace snug::cli
