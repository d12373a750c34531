#include <algorithm>
#include <string>

#include "snug/base/utf16.h"
#include "snug/formats/off_keyword.h"
#include "snug/formats/read.h"
#include "snug/formats/read_cloud.h"
#include "snug/formats/stl_kind.h"
#include "snug/formats/text_scan.h"

namespace snug {
namespace {

bool looks_like_ply(Bytes file) {
    TextScan text(file.first(std::min<std::size_t>(file.size(), 256)));
    return text.word('\0') == "ply" && text.word('\0').empty();
}

/// Whether the file's first statements are those of an OBJ file.
bool looks_like_obj(Bytes file) {
    static constexpr std::string_view kWords[] = {"v", "vt", "vn", "vp", "f",      "o",
                                                  "g", "s",  "l",  "p",  "mtllib", "usemtl"};
    TextScan text(file.first(std::min<std::size_t>(file.size(), 1 << 16)));
    const std::string_view word = text.word_anywhere();
    return std::find(std::begin(kWords), std::end(kWords), word) != std::end(kWords);
}

Result<Mesh> read_as(MeshFormat format, bool or_cloud, Bytes file) {
    switch (format) {
        case MeshFormat::stl:
            return read_stl(file);
        case MeshFormat::obj:
            return or_cloud ? read_obj_or_cloud(file) : read_obj(file);
        case MeshFormat::ply:
            return or_cloud ? read_ply_or_cloud(file) : read_ply(file);
        case MeshFormat::off:
            return or_cloud ? read_off_or_cloud(file) : read_off(file);
        case MeshFormat::shape:
            return read_shape(file);
    }
    return fail(ErrorKind::input, say("read.understood"));
}

/// Calls `read` with the file, or with its text where that is UTF-16.
template <class Read>
Result<Mesh> as_utf8(Bytes file, const Read& read) {
    const auto text = is_whole_binary_stl(file) ? std::nullopt : utf8_of_utf16(file);
    return read(text ? std::as_bytes(std::span(*text)) : file);
}

bool ends_with(std::string_view name, std::string_view lower) {
    return name.size() >= lower.size() && same_word(name.substr(name.size() - lower.size()), lower);
}

}  // namespace

Result<MeshFormat> mesh_format(Bytes file, std::string_view name) {
    if (file.empty()) return fail(ErrorKind::input, say("read.empty"));
    if (looks_like_ply(file)) return MeshFormat::ply;
    if (is_whole_binary_stl(file) || is_ascii_stl(file)) return MeshFormat::stl;
    if (const auto foreign = foreign_format(file)) return tl::unexpected(*foreign);
    TextScan scan(file.first(std::min<std::size_t>(file.size(), 1 << 12)));
    if (off_keyword(scan.word_anywhere())) return MeshFormat::off;
    if (looks_like_obj(file)) return MeshFormat::obj;
    if (ends_with(name, ".shape")) return MeshFormat::shape;

    if (ends_with(name, ".stl")) return MeshFormat::stl;
    if (ends_with(name, ".obj")) return MeshFormat::obj;
    if (ends_with(name, ".ply")) return MeshFormat::ply;
    if (ends_with(name, ".off")) return MeshFormat::off;
    return fail(ErrorKind::input, say("read.unknown", {{"understood", say("read.understood")}}));
}

Result<Mesh> read_mesh(Bytes file, std::string_view name) {
    return as_utf8(file, [&](Bytes bytes) -> Result<Mesh> {
        const auto format = mesh_format(bytes, name);
        return format ? read_as(*format, false, bytes) : tl::unexpected(format.error());
    });
}

Result<Mesh> read_mesh_or_cloud(Bytes file, std::string_view name) {
    return as_utf8(file, [&](Bytes bytes) -> Result<Mesh> {
        const bool named_cloud = ends_with(name, ".xyz") || ends_with(name, ".pts");
        const auto format = mesh_format(bytes, name);
        if (!format) return named_cloud && !bytes.empty() ? read_xyz(bytes) : tl::unexpected(format.error());
        return read_as(*format, true, bytes);
    });
}

}  // namespace snug
