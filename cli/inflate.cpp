#include "cli/inflate.h"

#include <algorithm>
#include <limits>
#include <zlib.h>

namespace snug::cli {
namespace {

constexpr std::size_t kFirstGuess = std::size_t{1} << 16;

/// zlib counts what is left in 32 bits.
uInt piece(std::size_t bytes) {
    return static_cast<uInt>(std::min<std::size_t>(bytes, std::numeric_limits<uInt>::max()));
}

tl::unexpected<Error> damaged() {
    return fail(ErrorKind::input, say("zip.damaged_bytes"));
}

}  // namespace

Result<FileBytes> inflate(Bytes packed, std::size_t most) {
    z_stream stream{};
    if (::inflateInit2(&stream, -MAX_WBITS) != Z_OK) return fail(ErrorKind::input, say("zip.no_memory"));
    FileBytes bytes(std::min(most, std::max(kFirstGuess, packed.size() * 4)));
    std::size_t taken = 0, made = 0;
    int state = Z_OK;
    while (state == Z_OK) {
        if (made == bytes.size()) bytes.resize(std::min(most, bytes.size() * 2));
        const uInt in = piece(packed.size() - taken), out = piece(bytes.size() - made);
        // zlib takes its input as const only where it was built so.
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(packed.data() + taken));
        stream.avail_in = in;
        std::byte beyond{};
        stream.next_out =
            out > 0 ? reinterpret_cast<Bytef*>(bytes.data() + made) : reinterpret_cast<Bytef*>(&beyond);
        stream.avail_out = out > 0 ? out : 1;  // at the limit only the end may follow
        state = ::inflate(&stream, Z_NO_FLUSH);
        taken += in - stream.avail_in;
        if (out == 0 && stream.avail_out == 0) state = Z_DATA_ERROR;
        if (out > 0) made += out - stream.avail_out;
    }
    (void)::inflateEnd(&stream);
    if (state != Z_STREAM_END) return damaged();
    bytes.resize(made);
    return bytes;
}

}  // namespace snug::cli
