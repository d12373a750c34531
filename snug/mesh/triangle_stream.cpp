#include "snug/mesh/triangle_stream.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "snug/base/parallel.h"
#include "snug/mesh/stl_layout.h"

namespace snug {
namespace {

/// Large enough for a disk, small enough for a cache: 3.2 MB of the file.
constexpr std::uint64_t kPiece = std::uint64_t{1} << 16;  // triangles

/// A worker's memory, kept from piece to piece.
struct Room {
    std::vector<std::byte> bytes;
    std::vector<TriangleStream::Corners> corners;
};

/// What went wrong first in the order of the file, whoever met it first.
class FirstError {
  public:
    void note(std::uint64_t piece, Error error) {
        const std::lock_guard lock(mutex_);
        if (piece >= piece_) return;
        piece_ = piece;
        error_ = std::move(error);
    }
    [[nodiscard]] bool before(std::uint64_t piece) {
        const std::lock_guard lock(mutex_);
        return piece_ < piece;
    }
    [[nodiscard]] Result<void> result() {
        if (piece_ == kNone) return {};
        return tl::unexpected(error_);
    }

  private:
    static constexpr std::uint64_t kNone = ~std::uint64_t{0};
    std::mutex mutex_;
    std::uint64_t piece_ = kNone;
    Error error_;
};

}  // namespace

Result<TriangleStream> TriangleStream::open(ByteSource source) {
    std::array<std::byte, kStlHeader> header;
    if (source.size < header.size())
        return fail(ErrorKind::input, "only a binary STL is read in pieces, and this file of " +
                                          grouped(source.size) + " bytes is none");
    if (auto done = source.read(0, header); !done) return tl::unexpected(done.error());
    const std::uint64_t count = read_u32(header.data() + 80);
    const std::uint64_t held = (source.size - kStlHeader) / kStlFacet;
    // Text in the place of the count is a count of more than a hundred million.
    const bool whole = (source.size - kStlHeader) % kStlFacet == 0 && held == count;
    if (!whole && held < count) {
        const bool text = std::all_of(header.begin() + 80, header.end(),
                                      [](std::byte b) { return b >= std::byte{9} && b < std::byte{127}; });
        if (text)
            return fail(ErrorKind::input,
                        "only a binary STL is read in pieces, and this is none: export it as one, or leave "
                        "--stream out where there is memory for it");
        return tl::unexpected(stl_cut_off(count, held));
    }
    if (count == 0) return fail(ErrorKind::input, "there are no triangles in this file");
    return TriangleStream(std::move(source), count);
}

Result<void> TriangleStream::pass(const std::function<void(std::span<const Corners>, std::size_t)>& visit,
                                  const Progress& progress) const {
    const std::uint64_t pieces = (count_ + kPiece - 1) / kPiece;
    std::vector<Room> rooms(worker_count());
    FirstError first;
    std::atomic<std::uint64_t> done = 0;
    std::atomic<bool> cancelled = false;
    std::mutex telling;
    parallel_for_workers(static_cast<std::size_t>(pieces), [&](std::size_t piece, std::size_t worker) {
        if (cancelled || first.before(piece)) return;
        Room& room = rooms[worker];
        const std::uint64_t begin = piece * kPiece, end = std::min(count_, begin + kPiece);
        const auto triangles = static_cast<std::size_t>(end - begin);
        room.bytes.resize(triangles * kStlFacet);
        room.corners.resize(triangles);
        if (auto read = source_.read(kStlHeader + begin * kStlFacet, room.bytes); !read)
            return first.note(piece, read.error());
        for (std::size_t t = 0; t < triangles; ++t)
            if (!read_stl_corners(room.bytes.data() + t * kStlFacet, room.corners[t]))
                return first.note(piece, stl_not_finite(begin + t, count_));
        visit(room.corners, worker);
        const double share = static_cast<double>(++done) / static_cast<double>(pieces);
        const std::lock_guard lock(telling);
        if (!cancelled && !go_on(progress, share)) cancelled = true;
    });
    if (cancelled) return fail(ErrorKind::cancelled, "cancelled");
    return first.result();
}

}  // namespace snug
