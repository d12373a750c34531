#include <algorithm>
#include <cstring>
#include <meshoptimizer.h>
#include <string_view>

#include "snug/formats/gltf_container.h"
#include "snug/formats/gltf_read.h"

#include "fuzz/check_mesh.h"

namespace {

using namespace snug;

void append_word(FileBytes& file, std::size_t value) {
    for (int i = 0; i < 4; ++i) file.push_back(static_cast<std::byte>(value >> (8 * i) & 0xFF));
}

/// A .glb of both parts: no mutation finds the lengths.
FileBytes glb_of(Bytes json, Bytes binary) {
    FileBytes file;
    append_word(file, 0x46546C67);
    append_word(file, 2);
    append_word(file, 28 + json.size() + binary.size());
    append_word(file, json.size());
    append_word(file, 0x4E4F534A);
    file.insert(file.end(), json.begin(), json.end());
    append_word(file, binary.size());
    append_word(file, 0x004E4942);
    file.insert(file.end(), binary.begin(), binary.end());
    return file;
}

Result<FileBytes> unpack_meshopt(Bytes packed, const MeshoptView& view) {
    FileBytes bytes(view.count * view.stride);
    const auto* from = reinterpret_cast<const unsigned char*>(packed.data());
    int failed = -1;
    if (view.mode == "ATTRIBUTES")
        failed = meshopt_decodeVertexBuffer(bytes.data(), view.count, view.stride, from, packed.size());
    else if (view.mode == "TRIANGLES")
        failed = meshopt_decodeIndexBuffer(bytes.data(), view.count, view.stride, from, packed.size());
    else
        failed = meshopt_decodeIndexSequence(bytes.data(), view.count, view.stride, from, packed.size());
    if (failed != 0) return fail(ErrorKind::input, as_it_is("damaged"));
    return bytes;
}

/// No Draco: eight points and some corners out of the bytes, which may be wrong in every way.
Result<DracoMesh> unpack_draco(Bytes packed, std::span<const DracoAttribute> attributes) {
    DracoMesh mesh;
    std::size_t at = 0;
    const auto next = [&] { return std::to_integer<int>(packed[at++ % packed.size()]); };
    for (const DracoAttribute& each : attributes) {
        mesh.attributes.emplace_back();
        for (int i = 0; i < 8 * each.components; ++i)
            mesh.attributes.back().push_back(static_cast<float>(next() - 64));
    }
    for (std::size_t i = 0; i < packed.size() % 64; ++i)
        mesh.corners.push_back(static_cast<std::uint32_t>(next() % 16));
    return mesh;
}

}  // namespace

/// A .glb as it is; anything else is JSON up to the first zero byte, and the bytes that it speaks of.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Bytes file = fuzz::bytes(data, size);
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const Bytes json = file.first(std::min(text.find('\0'), size));
    const Bytes binary = file.subspan(std::min(json.size() + 1, size));
    SceneTools tools;
    tools.beside = [&](const std::string& name) -> Result<FileBytes> {
        if (name.size() % 2 != 0) return fail(ErrorKind::input, as_it_is("not there"));
        return FileBytes(binary.begin(), binary.end());
    };
    tools.meshopt = unpack_meshopt;
    tools.draco = unpack_draco;
    const FileBytes whole = gltf::is_glb(file) ? FileBytes(file.begin(), file.end()) : glb_of(json, binary);
    const auto mesh = read_gltf(whole, tools);
    if (mesh && mesh->is_cloud())
        fuzz::check_vertices(*mesh);
    else
        fuzz::check(mesh);
    return 0;
}
