#include "snug/formats/gltf_extensions.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

#include "snug/base/text.h"

namespace snug::gltf {
namespace {

using Name = std::string_view;

constexpr Name kRead[] = {"KHR_mesh_quantization", "KHR_draco_mesh_compression", "EXT_meshopt_compression",
                          "EXT_mesh_gpu_instancing", "KHR_node_visibility"};

/// Looks, light, sound, movement and what is said about things: nothing that foam has to know.
constexpr Name kPassedOverFamilies[] = {
    "KHR_materials_", "EXT_materials_",  "ADOBE_materials_", "KHR_texture_",
    "EXT_texture_",   "MSFT_texture_",   "KHR_lights_",      "EXT_lights_",
    "KHR_audio",      "KHR_techniques_", "KHR_xmp",          "KHR_node_",
    "EXT_image_",     "OMI_audio",       "KHR_environment",  "EXT_environment"};
constexpr Name kPassedOver[] = {"KHR_animation_pointer",
                                "KHR_interactivity",
                                "MSFT_packing_occlusionRoughnessMetallic",
                                "MSFT_packing_normalRoughnessMetallic",
                                "CESIUM_primitive_outline",
                                "EXT_structural_metadata",
                                "EXT_feature_metadata",
                                "EXT_mesh_features",
                                "EXT_instance_features",
                                "EXT_mesh_manifold",
                                "FB_ngon_encoding",
                                "FB_geometry_metadata",
                                "MSFT_lod",
                                "EXT_mesh_primitive_edge_visibility",
                                "GODOT_single_root",
                                "KHR_mesh_variants",
                                "VRM",
                                "VRMC_vrm",
                                "VRMC_materials_mtoon",
                                "VRMC_springBone"};

bool is_passed_over(Name name) {
    return std::find(std::begin(kPassedOver), std::end(kPassedOver), name) != std::end(kPassedOver) ||
           std::any_of(std::begin(kPassedOverFamilies), std::end(kPassedOverFamilies),
                       [&](Name family) { return name.substr(0, family.size()) == family; });
}

Message unread(Name name) {
    const std::string shown = snug::quoted(name, 60);
    if (name == "KHR_meshopt_compression") return say("gltf.newer_meshopt", {{"extension", shown}});
    return say("gltf.unknown_extension", {{"extension", shown}});
}

}  // namespace

Result<void> check_extensions(const Json& scene) {
    const Json& required = field(scene, "extensionsRequired");
    for (std::uint64_t i = 0; i < count_of(required); ++i) {
        const Json& value = item(required, i);
        if (!value.is_string()) return refuse(say("gltf.extension_list"));
        const std::string& name = value.get_ref<const std::string&>();
        if (std::find(std::begin(kRead), std::end(kRead), name) != std::end(kRead)) continue;
        if (!is_passed_over(name)) return refuse(unread(name));
    }
    return {};
}

}  // namespace snug::gltf
