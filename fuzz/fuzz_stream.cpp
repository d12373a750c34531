#include <cstring>

#include "snug/formats/read.h"
#include "snug/formats/triangle_stream.h"
#include "snug/object/streamed_bounds.h"
#include "snug/words/words.h"

#include "fuzz/check_mesh.h"

// A file that is read in pieces: what the stream takes, the reader of the whole file takes too, with as many
// triangles and within the same box.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace snug;
    const ByteSource source{size, [data](std::uint64_t at, std::span<std::byte> into) -> Result<void> {
                                std::memcpy(into.data(), data + at, into.size());
                                return {};
                            }};
    const auto stream = TriangleStream::open(source);
    if (!stream) {
        fuzz::require(!text(stream.error().message).empty());
        return 0;
    }
    const auto bounds = streamed_bounds(*stream, {}, {});
    const auto mesh = read_mesh(fuzz::bytes(data, size), "object");
    if (!bounds || !mesh) return 0;
    fuzz::require(mesh->triangles.size() == bounds->triangles);
    if (mesh->origin == Vec3d{} && stream->origin() == Vec3d{})
        fuzz::require(snug::bounds(*mesh) == bounds->file);
    return 0;
}
