#include "snug/formats/read_object.h"

#include "snug/formats/bundle.h"
#include "snug/formats/gltf_read.h"
#include "snug/formats/read_cloud.h"
#include "snug/formats/text_scan.h"
#include "snug/formats/zip_read.h"

namespace snug {
namespace {

bool has_ending(std::string_view name, std::string_view lower) {
    return name.size() >= lower.size() && same_word(name.substr(name.size() - lower.size()), lower);
}

bool is_gltf(Bytes file, std::string_view name) {
    const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    return text.substr(0, 4) == "glTF" || has_ending(name, ".gltf") || has_ending(name, ".glb");
}

/// A file that is no zip.
Result<Mesh> read_single(Bytes file, std::string_view name, const SceneTools& tools) {
    return is_gltf(file, name) ? read_gltf(file, tools) : read_mesh_or_cloud(file, name);
}

}  // namespace

Result<Mesh> read_object(Bytes file, std::string_view name, const SceneTools& tools) {
    return is_zip(file) ? read_zip(file, tools, read_single) : read_single(file, name, tools);
}

}  // namespace snug
