#include "wasm/scene_tools.h"

#include <string>
#include <utility>

#include "wasm/values.h"

namespace snug::wasm {
namespace {

val view_of(Bytes bytes) {
    return val(
        emscripten::typed_memory_view(bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data())));
}

bool none(const val& answer) {
    return answer.isNull() || answer.isUndefined();
}

Result<FileBytes> bytes_or(const val& answer, Message refusal) {
    if (none(answer)) return fail(ErrorKind::input, std::move(refusal));
    return bytes_from(answer);
}

/// Files are opened without their folders.
std::string without_folders(const std::string& path) {
    return path.substr(path.find_last_of("/\\") + 1);
}

std::vector<std::uint32_t> whole_numbers_from(const val& uint32_array) {
    std::vector<std::uint32_t> numbers(uint32_array["length"].as<std::size_t>());
    val(emscripten::typed_memory_view(numbers.size(), numbers.data())).call<void>("set", uint32_array);
    return numbers;
}

Result<DracoMesh> unpack_draco(const val& tool, Bytes packed, std::span<const DracoAttribute> attributes) {
    val asked = val::array();
    for (const DracoAttribute& each : attributes) {
        val one = val::object();
        one.set("id", each.id);
        one.set("components", each.components);
        asked.call<void>("push", one);
    }
    const val answer = tool(view_of(packed), asked);
    if (none(answer)) return fail(ErrorKind::input, say("draco.damaged"));
    DracoMesh mesh;
    for (std::size_t i = 0; i < attributes.size(); ++i)
        mesh.attributes.push_back(floats_from(answer["attributes"][i]));
    mesh.corners = whole_numbers_from(answer["corners"]);
    return mesh;
}

}  // namespace

SceneTools scene_tools_from(const val& given) {
    SceneTools tools;
    if (none(given)) return tools;
    const auto tool = [&](const char* name) -> std::optional<val> {
        const val found = given[name];
        if (none(found)) return {};
        return found;
    };
    if (const auto beside = tool("beside"))
        tools.beside = [call = *beside](const std::string& path) {
            const std::string name = without_folders(path);
            return bytes_or(call(name), say("gltf.geometry_not_opened", {{"name", name}}));
        };
    if (const auto inflate = tool("inflate"))
        tools.inflate = [call = *inflate](Bytes packed, std::size_t most) {
            return bytes_or(call(view_of(packed), static_cast<double>(most)), say("zip.damaged_bytes"));
        };
    if (const auto meshopt = tool("meshopt"))
        tools.meshopt = [call = *meshopt](Bytes packed, const MeshoptView& view) {
            return bytes_or(call(view_of(packed), static_cast<double>(view.count),
                                 static_cast<double>(view.stride), view.mode),
                            say("meshopt.damaged"));
        };
    if (const auto draco = tool("draco"))
        tools.draco = [call = *draco](Bytes packed, std::span<const DracoAttribute> attributes) {
            return unpack_draco(call, packed, attributes);
        };
    return tools;
}

}  // namespace snug::wasm
