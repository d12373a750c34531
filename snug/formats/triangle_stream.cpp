#include "snug/formats/triangle_stream.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/parallel.h"
#include "snug/formats/ply_stream.h"
#include "snug/formats/read.h"
#include "snug/formats/stl_kind.h"
#include "snug/formats/stl_layout.h"

namespace snug {
namespace {

/// Whether the count's place holds text, as in an ASCII STL or any other file of text.
bool is_all_text(std::span<const std::byte> bytes) {
    return std::all_of(bytes.begin(), bytes.end(),
                       [](std::byte b) { return b >= std::byte{9} && b < std::byte{127}; });
}

Error not_in_pieces(std::span<const std::byte> beginning) {
    if (const auto foreign = foreign_format(beginning)) return *foreign;
    return {ErrorKind::input, say("read.pieces_formats")};
}

/// Whether the file is the text that read_stl() would take it for: only where it has not the very size of a
/// binary STL.
Result<bool> is_read_as_text(ByteSource& source, std::uint64_t count) {
    if (source.size == kStlHeader + count * kStlFacet) return false;
    std::vector<std::byte> start(
        static_cast<std::size_t>(std::min<std::uint64_t>(source.size, kStlKindBytes)));
    if (auto done = source.read(0, start); !done) return tl::unexpected(done.error());
    return is_ascii_stl(start);
}

Result<TriangleStream> open_stl(ByteSource source) {
    std::array<std::byte, kStlHeader> room;
    const std::span header =
        std::span(room).first(static_cast<std::size_t>(std::min<std::uint64_t>(source.size, room.size())));
    if (auto done = source.read(0, header); !done) return tl::unexpected(done.error());
    if (header.size() < room.size()) return tl::unexpected(not_in_pieces(header));
    const std::uint64_t count = read_u32(header.data() + 80);
    const std::uint64_t held = (source.size - kStlHeader) / kStlFacet;
    if (held < count) {
        if (is_all_text(header.last(4))) return tl::unexpected(not_in_pieces(header));
        return tl::unexpected(stl_cut_off(count, held));
    }
    const auto text = is_read_as_text(source, count);
    if (!text) return tl::unexpected(text.error());
    if (*text) return tl::unexpected(not_in_pieces(header));
    if (const auto foreign = count == 0 ? foreign_format(header) : std::nullopt)
        return tl::unexpected(*foreign);
    if (count == 0) return fail(ErrorKind::input, say("mesh.no_triangles"));
    const auto decode = [](const RecordPiece& piece,
                           std::span<TriangleStream::Corners> corners) -> Result<std::size_t> {
        for (std::size_t t = 0; t < piece.count; ++t)
            copy_stl_corners(piece.bytes.data() + t * kStlFacet, corners[t]);
        return usable_first(corners);
    };
    return TriangleStream(std::move(source), {kStlHeader, count, kStlFacet}, decode);
}

}  // namespace

Result<TriangleStream> TriangleStream::open(ByteSource source, const Progress& progress) {
    std::array<std::byte, 4> magic{};
    if (source.size >= magic.size())
        if (auto done = source.read(0, magic); !done) return tl::unexpected(done.error());
    const std::string_view word(reinterpret_cast<const char*>(magic.data()), magic.size());
    if (word == "ply\n" || word == "ply\r") return open_ply_stream(std::move(source), progress);
    return open_stl(std::move(source));
}

TriangleStream TriangleStream::divided(Divide divide) const {
    TriangleStream pieces = *this;
    pieces.divide_ = std::move(divide);
    return pieces;
}

Result<void> TriangleStream::pass(const std::function<void(std::span<const Corners>, std::size_t)>& visit,
                                  const Progress& progress) const {
    constexpr std::size_t kManyPieces = 1 << 14;
    struct Room {
        std::vector<Corners> corners, pieces;
    };
    std::vector<Room> rooms(worker_count());
    return pass_records(
        source_, records_,
        [&](const RecordPiece& piece) -> Result<void> {
            auto& [corners, pieces] = rooms[piece.worker];
            corners.resize(piece.count);
            const auto usable = decode_(piece, corners);
            if (!usable) return tl::unexpected(usable.error());
            const auto show = [&](std::span<const Corners> all) {
                if (!all.empty()) visit(all, piece.worker);
            };
            const auto whole = std::span<const Corners>(corners).first(*usable);
            if (!divide_) {
                show(whole);
                return {};
            }
            pieces.clear();
            for (const Corners& each : whole) {
                divide_(each, pieces);
                if (pieces.size() < kManyPieces) continue;
                show(pieces);
                pieces.clear();
            }
            show(pieces);
            return {};
        },
        progress);
}

}  // namespace snug
