#pragma once

#include <cstddef>
#include <cstdint>

#include "snug/base/bytes.h"

namespace snug {

/// The unsigned number of `count` (1 to 8) bytes at `at`, least first; they must lie within the file.
[[nodiscard]] inline std::uint64_t little_endian(Bytes file, std::uint64_t at, int count) {
    std::uint64_t value = 0;
    for (int i = count - 1; i >= 0; --i)
        value = value << 8 | std::to_integer<std::uint64_t>(
                                 file[static_cast<std::size_t>(at) + static_cast<std::size_t>(i)]);
    return value;
}

/// `size` bytes from `begin` on; they must lie within the file.
[[nodiscard]] inline Bytes part_of(Bytes file, std::uint64_t begin, std::uint64_t size) {
    return file.subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(size));
}

}  // namespace snug
