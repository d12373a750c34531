#include "cli/scene_tools.h"

#include <algorithm>
#include <meshoptimizer.h>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "cli/draco_process.h"
#include "cli/files.h"
#include "cli/inflate.h"

namespace snug::cli {
namespace {

namespace fs = std::filesystem;

/// Only what lies in the folder or below it, wherever links lead.
Result<FileBytes> read_beside(const fs::path& folder, std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    std::error_code error;
    const fs::path root = fs::weakly_canonical(folder, error);
    const fs::path real = error ? fs::path() : fs::weakly_canonical(root / name, error);
    const bool inside =
        !error && std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first == root.end();
    if (!inside) return fail(ErrorKind::input, say("gltf.geometry_at", {{"name", name}}));
    if (!fs::exists(real, error))
        return fail(ErrorKind::input, say("gltf.geometry_not_beside", {{"name", name}}));
    if (!fs::is_regular_file(real, error))
        return fail(ErrorKind::input, say("gltf.geometry_no_file", {{"name", name}}));
    return read_file(real);
}

Result<FileBytes> unpack_meshopt(Bytes packed, const MeshoptView& view) {
    FileBytes bytes(view.count * view.stride);
    const auto* from = reinterpret_cast<const unsigned char*>(packed.data());
    int failed = -1;
    if (view.mode == "ATTRIBUTES")
        failed = meshopt_decodeVertexBuffer(bytes.data(), view.count, view.stride, from, packed.size());
    else if (view.mode == "TRIANGLES")
        failed = meshopt_decodeIndexBuffer(bytes.data(), view.count, view.stride, from, packed.size());
    else if (view.mode == "INDICES")
        failed = meshopt_decodeIndexSequence(bytes.data(), view.count, view.stride, from, packed.size());
    if (failed != 0) return fail(ErrorKind::input, say("meshopt.damaged"));
    return bytes;
}

}  // namespace

SceneTools scene_tools(const fs::path& scene) {
    const fs::path folder = scene.parent_path().empty() ? fs::path(".") : scene.parent_path();
    return {[folder](const std::string& name) { return read_beside(folder, name); }, inflate, unpack_meshopt,
            unpack_draco_in_a_process};
}

}  // namespace snug::cli
