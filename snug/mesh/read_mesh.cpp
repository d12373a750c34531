#include <algorithm>
#include <string>

#include "snug/mesh/read.h"
#include "snug/mesh/stl_kind.h"
#include "snug/mesh/text_scan.h"

namespace snug {
namespace {

constexpr const char* kUnderstood =
    "Snug reads STL, OBJ, PLY, OFF, glTF, 3MF and points as PLY, XYZ or PTS: export it as one of these";

std::string_view text_of(Bytes bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool starts_with(std::string_view text, std::string_view start) {
    return text.substr(0, start.size()) == start;
}

/// The name of a format that is known but not read; empty otherwise.
std::string_view foreign_name(std::string_view text) {
    if (starts_with(text, "PK\x03\x04")) return "a zip or 3MF file";
    if (starts_with(text, "glTF")) return "a glTF file";
    if (starts_with(text, "ISO-10303-21")) return "a STEP file";
    if (starts_with(text, "Kaydara FBX")) return "an FBX file";
    if (starts_with(text, "BLENDER")) return "a Blender file";
    if (starts_with(text, "ASTM-E57")) return "an E57 scan";
    if (starts_with(text, "LASF")) return "a LAS or LAZ scan";
    return {};
}

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

bool ends_with(std::string_view name, std::string_view lower) {
    return name.size() >= lower.size() && same_word(name.substr(name.size() - lower.size()), lower);
}

}  // namespace

std::optional<Error> foreign_format(Bytes beginning) {
    const auto name = foreign_name(text_of(beginning));
    if (name.empty()) return {};
    return Error{ErrorKind::input, "this is " + std::string(name) + ": export it as STL, OBJ or PLY instead"};
}

Result<MeshFormat> mesh_format(Bytes file, std::string_view name) {
    const std::string_view text = text_of(file);
    if (text.empty()) return fail(ErrorKind::input, "the file is empty");
    if (looks_like_ply(file)) return MeshFormat::ply;
    if (is_whole_binary_stl(file) || is_ascii_stl(file)) return MeshFormat::stl;
    if (const auto foreign = foreign_format(file)) return tl::unexpected(*foreign);
    TextScan scan(file.first(std::min<std::size_t>(file.size(), 1 << 12)));
    if (const auto word = scan.word_anywhere();
        word.size() >= 3 && word.size() <= 8 && ends_with(word, "off"))
        return MeshFormat::off;
    if (looks_like_obj(file)) return MeshFormat::obj;

    if (ends_with(name, ".stl")) return MeshFormat::stl;
    if (ends_with(name, ".obj")) return MeshFormat::obj;
    if (ends_with(name, ".ply")) return MeshFormat::ply;
    if (ends_with(name, ".off")) return MeshFormat::off;
    return fail(ErrorKind::input, std::string("this is no mesh that Snug knows; ") + kUnderstood);
}

Result<Mesh> read_mesh(Bytes file, std::string_view name) {
    const auto format = mesh_format(file, name);
    if (!format) return tl::unexpected(format.error());
    switch (*format) {
        case MeshFormat::stl:
            return read_stl(file);
        case MeshFormat::obj:
            return read_obj(file);
        case MeshFormat::ply:
            return read_ply(file);
        case MeshFormat::off:
            return read_off(file);
    }
    return fail(ErrorKind::input, kUnderstood);
}

}  // namespace snug
