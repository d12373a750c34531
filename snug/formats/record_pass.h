#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "snug/base/byte_source.h"
#include "snug/base/progress.h"
#include "snug/base/result.h"

namespace snug {

/// A part of a file that consists of records of one size: an STL's triangles, a PLY's vertices.
struct Records {
    std::uint64_t begin = 0;  ///< of the first, in bytes from the file's start
    std::uint64_t count = 0;
    std::size_t bytes = 0;  ///< of one, 1 or more

    [[nodiscard]] std::uint64_t end() const { return begin + count * bytes; }
};

/// Some records that follow each other; `worker` as in parallel_for_workers().
struct RecordPiece {
    std::span<const std::byte> bytes;
    std::uint64_t first = 0;  ///< number of the first
    std::size_t count = 0;
    std::size_t worker = 0;
};

/// Reads all records once and shows them to `visit` in pieces of some 100 kB, in any order and on several
/// threads. Fails with what went wrong first in the order of the file, whoever met it first, and with kind
/// `cancelled`.
[[nodiscard]] Result<void> pass_records(const ByteSource& source, const Records& records,
                                        const std::function<Result<void>(const RecordPiece&)>& visit,
                                        const Progress& progress = {});

}  // namespace snug
