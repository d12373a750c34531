#pragma once

#include <cstdint>
#include <filesystem>

#include "snug/base/byte_source.h"
#include "snug/base/result.h"

namespace snug::cli {

/// A regular file, read piece by piece; it stays open as long as a copy of the source lives. Fails with kind
/// `input`, naming the file, where it cannot be opened or is no regular file. Its reads fail, without the
/// name, where the disk does or the file has become shorter since.
[[nodiscard]] Result<ByteSource> open_source(const std::filesystem::path& path);

/// Whether reading the file whole would take more than a fair share of the memory that this machine has and
/// this program may use: a mesh takes two to three times its file while it is read.
[[nodiscard]] bool too_large_for_memory(std::uint64_t bytes);

}  // namespace snug::cli
