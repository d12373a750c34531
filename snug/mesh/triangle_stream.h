#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "snug/base/byte_source.h"
#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/base/vec.h"

namespace snug {

/// The triangles of a file that is never whole in memory: a binary STL. A pass over them reads the file once,
/// in pieces of some MB a worker.
class TriangleStream {
  public:
    using Corners = std::array<Vec3f, 3>;  ///< as the file has them

    /// Reads the header. Fails (kind `input`) where it is no binary STL, with what to do, and where it is cut
    /// off.
    [[nodiscard]] static Result<TriangleStream> open(ByteSource source);

    [[nodiscard]] std::uint64_t triangles() const { return count_; }

    /// Shows all triangles to `visit` in pieces, in any order and on several threads; `worker` as in
    /// parallel_for_workers(). Fails with the first triangle of the file that has a coordinate which is not
    /// finite, where reading fails, and when cancelled.
    [[nodiscard]] Result<void> pass(
        const std::function<void(std::span<const Corners> piece, std::size_t worker)>& visit,
        const Progress& progress = {}) const;

  private:
    TriangleStream(ByteSource source, std::uint64_t count) : source_(std::move(source)), count_(count) {}

    ByteSource source_;
    std::uint64_t count_;
};

}  // namespace snug
