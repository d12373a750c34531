#include <algorithm>
#include <array>

#include "snug/base/text.h"
#include "snug/formats/read.h"
#include "snug/formats/stl_kind.h"
#include "snug/formats/stl_layout.h"
#include "snug/formats/text_scan.h"
#include "snug/mesh/raw_mesh.h"
#include "snug/mesh/welder.h"

namespace snug {
namespace {

constexpr std::size_t kStart = 4096;  // bytes that are looked at to tell text from numbers

Result<Mesh> read_binary(Bytes file) {
    if (file.size() < kStlHeader)
        return fail(ErrorKind::input, say("stl.too_short", {{"bytes", file.size()}}));
    const std::size_t count = read_u32(file.data() + 80);
    const std::size_t held = (file.size() - kStlHeader) / kStlFacet;
    if (held < count) return tl::unexpected(stl_cut_off(count, held));
    RawMeshOf<float> mesh;
    mesh.triangles.reserve(count);
    mesh.vertices.reserve(count / 2 + 3);
    mesh.read.faces = count;
    Welder<float> welder(mesh, count);
    std::array<Welder<float>::Corners, Welder<float>::kBatch> batch;
    std::size_t held_back = 0;
    for (std::size_t t = 0; t < count; ++t) {
        copy_stl_corners(file.data() + kStlHeader + t * kStlFacet, batch[held_back]);
        held_back += all_usable(std::span(batch).subspan(held_back, 1));
        if (held_back < batch.size()) continue;
        welder.append(batch);
        held_back = 0;
    }
    welder.append(std::span(batch).first(held_back));
    mesh.read.left_out_faces = count - mesh.triangles.size();
    return finish(std::move(mesh));
}

/// How many triangles a binary STL says that it has.
std::size_t stated_count(Bytes file) {
    return read_u32(file.data() + 80);
}

/// Bytes that no text holds, in any encoding but UTF-16.
bool is_text(Bytes start) {
    return std::none_of(start.begin(), start.end(), [](std::byte b) {
        return b < std::byte{0x20} && b != std::byte{'\t'} && b != std::byte{'\n'} && b != std::byte{'\r'} &&
               b != std::byte{'\f'} && b != std::byte{'\v'} && b != std::byte{0x1a};
    });
}

Error no_stl(Bytes start) {
    const std::string_view text(reinterpret_cast<const char*>(start.data()), start.size());
    const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    return {
        ErrorKind::input,
        say("stl.text", {{"text", quoted(text.substr(begin, text.find_first_of("\r\n", begin) - begin))}})};
}

}  // namespace

bool is_whole_binary_stl(Bytes file) {
    return file.size() >= kStlHeader && (file.size() - kStlHeader) % kStlFacet == 0 &&
           (file.size() - kStlHeader) / kStlFacet == stated_count(file);
}

/// Programs write "solid" at the start of binary files, too, and some put further bytes behind the triangles.
/// Text in the place of the count would be a count of more than 100 million.
Result<Mesh> read_stl(Bytes file) {
    if (is_whole_binary_stl(file)) return read_binary(file);
    if (is_ascii_stl(file)) return read_ascii_stl(file);
    const bool has_room =
        file.size() >= kStlHeader && (file.size() - kStlHeader) / kStlFacet >= stated_count(file);
    const Bytes start = file.first(std::min(file.size(), kStart));
    if (has_room || !is_text(start)) return read_binary(file);
    const bool says_solid = same_word(TextScan(start).word_anywhere('\0'), "solid");
    return says_solid ? read_ascii_stl(file) : tl::unexpected(no_stl(start));
}

}  // namespace snug
