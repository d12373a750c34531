#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace snug {

/// A file, or a part of one, as it was read: hostile until checked.
using Bytes = std::span<const std::byte>;

/// A file in the making.
using FileBytes = std::vector<std::byte>;

}  // namespace snug
