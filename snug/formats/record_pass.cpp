#include "snug/formats/record_pass.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>
#include <vector>

#include "snug/base/parallel.h"

namespace snug {
namespace {

/// Large enough for a disk, small enough for the second level of a cache.
constexpr std::uint64_t kPieceBytes = 400'000;

/// What went wrong first in the order of the file, whoever met it first.
class FirstError {
  public:
    void note(std::uint64_t piece, Error error) {
        const std::lock_guard lock(mutex_);
        if (piece >= piece_) return;
        piece_ = piece;
        error_ = std::move(error);
    }
    [[nodiscard]] bool before(std::uint64_t piece) const { return piece_ < piece; }
    [[nodiscard]] Result<void> result() const {
        if (piece_ == kNone) return {};
        return tl::unexpected(error_);
    }

  private:
    static constexpr std::uint64_t kNone = ~std::uint64_t{0};
    std::mutex mutex_;
    std::atomic<std::uint64_t> piece_ = kNone;
    Error error_;
};

}  // namespace

Result<void> pass_records(const ByteSource& source, const Records& records,
                          const std::function<Result<void>(const RecordPiece&)>& visit,
                          const Progress& progress) {
    const std::uint64_t per_piece = std::max<std::uint64_t>(kPieceBytes / records.bytes, 1);
    const std::uint64_t pieces = (records.count + per_piece - 1) / per_piece;
    std::vector<std::vector<std::byte>> rooms(worker_count());
    FirstError first;
    std::atomic<std::uint64_t> done = 0;
    std::atomic<bool> cancelled = false;
    std::mutex telling;
    parallel_for_workers(static_cast<std::size_t>(pieces), [&](std::size_t piece, std::size_t worker) {
        if (cancelled || first.before(piece)) return;
        const std::uint64_t begin = piece * per_piece;
        const auto count = static_cast<std::size_t>(std::min(per_piece, records.count - begin));
        std::vector<std::byte>& bytes = rooms[worker];
        bytes.resize(count * records.bytes);
        if (auto read = source.read(records.begin + begin * records.bytes, bytes); !read)
            return first.note(piece, read.error());
        if (auto seen = visit({bytes, begin, count, worker}); !seen) return first.note(piece, seen.error());
        const double share = static_cast<double>(++done) / static_cast<double>(pieces);
        const std::lock_guard lock(telling);
        if (!cancelled && !go_on(progress, share)) cancelled = true;
    });
    if (cancelled) return fail(ErrorKind::cancelled, say("cancelled"));
    return first.result();
}

}  // namespace snug
