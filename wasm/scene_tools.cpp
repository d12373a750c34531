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

/// Where a tool has no answer, why.
std::optional<Error> refusal(const val& answer) {
    if (answer.isString()) return Error{ErrorKind::input, answer.as<std::string>()};
    if (answer.isNull() || answer.isUndefined()) return Error{ErrorKind::input, say("packed.damaged")};
    return {};
}

Result<FileBytes> bytes_or_refusal(const val& answer) {
    if (const auto refused = refusal(answer)) return tl::unexpected(*refused);
    return bytes_from(answer);
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
    if (const auto refused = refusal(answer)) return tl::unexpected(*refused);
    DracoMesh mesh;
    for (std::size_t i = 0; i < attributes.size(); ++i)
        mesh.attributes.push_back(floats_from(answer["attributes"][i]));
    mesh.corners = whole_numbers_from(answer["corners"]);
    return mesh;
}

}  // namespace

SceneTools scene_tools_from(const val& given) {
    SceneTools tools;
    if (given.isNull() || given.isUndefined()) return tools;
    const auto tool = [&](const char* name) -> std::optional<val> {
        const val found = given[name];
        if (found.isNull() || found.isUndefined()) return {};
        return found;
    };
    if (const auto beside = tool("beside"))
        tools.beside = [call = *beside](const std::string& name) { return bytes_or_refusal(call(name)); };
    if (const auto inflate = tool("inflate"))
        tools.inflate = [call = *inflate](Bytes packed, std::size_t most) {
            return bytes_or_refusal(call(view_of(packed), static_cast<double>(most)));
        };
    if (const auto meshopt = tool("meshopt"))
        tools.meshopt = [call = *meshopt](Bytes packed, const MeshoptView& view) {
            return bytes_or_refusal(call(view_of(packed), static_cast<double>(view.count),
                                         static_cast<double>(view.stride), view.mode));
        };
    if (const auto draco = tool("draco"))
        tools.draco = [call = *draco](Bytes packed, std::span<const DracoAttribute> attributes) {
            return unpack_draco(call, packed, attributes);
        };
    return tools;
}

}  // namespace snug::wasm
