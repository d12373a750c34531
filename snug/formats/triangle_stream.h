#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "snug/base/byte_source.h"
#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/formats/record_pass.h"

namespace snug {

/// The triangles of a file that is never whole in memory: a binary STL, or a binary PLY of triangles, of
/// which only the vertices are kept (12 bytes each). A pass over them reads the file once, in small pieces.
class TriangleStream {
  public:
    using Corners = std::array<Vec3f, 3>;  ///< relative to origin()
    /// Turns records into corners, and says how many: those with a corner that is not usable() (left_out.h)
    /// are left out. Or says what is wrong with the first that is wrong.
    using Decode = std::function<Result<std::size_t>(const RecordPiece&, std::span<Corners>)>;

    /// Reads the header, and a PLY's vertices. Fails (kind `input`) where it is no file of these kinds, with
    /// what to do, and where it is cut off.
    [[nodiscard]] static Result<TriangleStream> open(ByteSource source, const Progress& progress = {});

    TriangleStream(ByteSource source, Records records, Decode decode)
        : source_(std::move(source)), records_(records), decode_(std::move(decode)) {}

    /// As many as the file has; pass() may leave some out.
    [[nodiscard]] std::uint64_t triangles() const { return records_.count; }
    /// As many as the file has; none where its triangles share none, as an STL's.
    [[nodiscard]] std::optional<std::uint64_t> vertices() const { return vertices_; }
    /// Zero, unless the file's numbers are more exact than a float: then as a mesh in memory has it.
    [[nodiscard]] Vec3d origin() const { return origin_; }

    /// Shows all triangles that are usable to `visit` in pieces, in any order and on several threads;
    /// `worker` as in parallel_for_workers(). Fails with the first triangle of the file that is wrong, where
    /// reading fails, and when cancelled.
    [[nodiscard]] Result<void> pass(
        const std::function<void(std::span<const Corners> piece, std::size_t worker)>& visit,
        const Progress& progress = {}) const;

    /// Appends what a triangle comes to: pieces of it, or nothing.
    using Divide = std::function<void(const Corners&, std::vector<Corners>&)>;
    /// The same file, of whose triangles a pass shows what they come to; `divide` is asked from several
    /// threads.
    [[nodiscard]] TriangleStream divided(Divide divide) const;

    TriangleStream& with_vertices(std::uint64_t count, Vec3d origin) {
        vertices_ = count;
        origin_ = origin;
        return *this;
    }

  private:
    ByteSource source_;
    Records records_;
    Decode decode_;
    Divide divide_;  ///< may be none
    std::optional<std::uint64_t> vertices_;
    Vec3d origin_;
};

}  // namespace snug
