#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "snug/base/result.h"

namespace snug {

/// Bytes that are too many to hold: read piece by piece, in any order and on several threads at once.
struct ByteSource {
    std::uint64_t size = 0;
    /// Fills `into` from `at` on, all of which lies within `size`, or says why it cannot (kind `input`): the
    /// file has shrunk, the disk fails.
    std::function<Result<void>(std::uint64_t at, std::span<std::byte> into)> read;
};

}  // namespace snug
