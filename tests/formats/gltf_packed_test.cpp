#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/words/words.h"

#include "tests/support/gltf_checks.h"

// Geometry that decoders unpack: what is asked of them, what is checked before and after.

namespace snug::test {
namespace {

/// The box whose places a decoder gives; the packed bytes have `header` and then nothing of use.
GltfBuilder meshopt_box(std::uint8_t header, std::size_t packed_bytes = 64) {
    GltfBuilder scene = box_scene();
    const std::vector<std::uint8_t> packed(packed_bytes, header);
    const int view = scene.view(packed.data(), packed.size());
    auto& places = scene.json["bufferViews"][0];
    places["extensions"]["EXT_meshopt_compression"] = {
        {"buffer", 0},
        {"byteOffset", scene.json["bufferViews"][static_cast<std::size_t>(view)]["byteOffset"]},
        {"byteLength", packed_bytes},
        {"byteStride", 12},
        {"count", 8},
        {"mode", "ATTRIBUTES"}};
    scene.json["extensionsRequired"] = {"EXT_meshopt_compression"};
    return scene;
}

TEST(Gltf, WhatMeshoptPackedIsAskedForOnceAndUnfiltered) {
    const GltfBox box;
    int asked = 0;
    SceneTools tools;
    tools.meshopt = [&](Bytes packed, const MeshoptView& view) -> Result<FileBytes> {
        ++asked;
        EXPECT_EQ(packed.size(), 64U);
        EXPECT_EQ(view.count, 8U);
        EXPECT_EQ(view.stride, 12U);
        EXPECT_EQ(view.mode, "ATTRIBUTES");
        FileBytes bytes(96);
        std::memcpy(bytes.data(), box.places.data(), 96);
        return bytes;
    };
    GltfBuilder scene = meshopt_box(0xA0);
    // What stands in the plain view is not looked at.
    std::memset(scene.binary.data(), 0x55, 96);
    scene.node({{"mesh", 0}, {"translation", {1, 0, 0}}});
    const auto twice = read_gltf(scene.glb(), tools);
    ASSERT_TRUE(twice.has_value()) << text(twice.error().message);
    EXPECT_EQ(twice->triangles.size(), 24U);
    EXPECT_EQ(asked, 1);

    // The same places as whole numbers times a power of two.
    tools.meshopt = [&](Bytes, const MeshoptView&) -> Result<FileBytes> {
        FileBytes bytes(96);
        for (std::size_t i = 0; i < 24; ++i) {
            const auto mantissa =
                static_cast<std::uint32_t>(std::lround(box.places[i] * 33554432)) & 0xFFFFFF;
            const std::uint32_t word = mantissa | static_cast<std::uint32_t>(-25) << 24;
            std::memcpy(&bytes[4 * i], &word, 4);
        }
        return bytes;
    };
    GltfBuilder filtered = meshopt_box(0xA0);
    filtered.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["filter"] = "EXPONENTIAL";
    expect_box(read_gltf(filtered.glb(), tools));
}

TEST(Gltf, NewerCodecsAndClaimsOfMeshoptAreRefusedBeforeTheDecoderIsAsked) {
    SceneTools tools;
    tools.meshopt = [](Bytes, const MeshoptView&) -> Result<FileBytes> {
        ADD_FAILURE() << "the decoder was asked";
        return FileBytes{};
    };
    EXPECT_NE(refused_scene(meshopt_box(0xA1).glb(), tools).find("newer codec"), std::string::npos);
    GltfBuilder claims = meshopt_box(0xA0);
    claims.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["count"] = 120'000'000;
    EXPECT_NE(refused_scene(claims.glb(), tools).find("120,000,000"), std::string::npos);
    EXPECT_NE(refused_scene(meshopt_box(0xA0).glb(), {}).find("meshopt"), std::string::npos);
}

TEST(Gltf, WhereMeshoptIsNotRequiredTheFallbackIsRead) {
    GltfBuilder scene = meshopt_box(0xA1);
    scene.json.erase("extensionsRequired");
    expect_box(read_gltf(scene.glb(), {}));
}

/// The box as Draco would give it, behind a header of Draco that claims `faces`.
GltfBuilder draco_box(std::vector<std::uint8_t> faces) {
    std::vector<std::uint8_t> packed{'D', 'R', 'A', 'C', 'O', 2, 2, 1, 0, 0, 0};
    packed.insert(packed.end(), faces.begin(), faces.end());
    packed.resize(64, 0);
    GltfBuilder scene = box_scene();
    const int view = scene.view(packed.data(), packed.size());
    scene.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", view}, {"attributes", {{"POSITION", 3}}}};
    scene.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    return scene;
}

TEST(Gltf, WhatDracoPackedIsScaledAsItsAccessorSays) {
    SceneTools tools;
    tools.draco = [](Bytes, std::span<const DracoAttribute> asked) -> Result<DracoMesh> {
        EXPECT_EQ(asked.size(), 1U);
        EXPECT_EQ(asked[0].id, 3);
        EXPECT_EQ(asked[0].components, 3);
        const GltfBox box;
        DracoMesh mesh;
        mesh.attributes.emplace_back();
        for (const float each : box.places)
            mesh.attributes[0].push_back(static_cast<float>(std::round(each * 200000)));
        mesh.corners.assign(box.corners.begin(), box.corners.end());
        return mesh;
    };
    GltfBuilder scene = draco_box({12});
    auto& places = scene.json["accessors"][0];
    places.erase("bufferView");
    places["componentType"] = 5122;
    places["normalized"] = true;
    const double scale = 32767.0 / 200000;
    scene.json["nodes"][0]["scale"] = {scale, scale, scale};
    expect_box(read_gltf(scene.glb(), tools));
}

TEST(Gltf, ClaimsAndDamageOfDracoAreRefused) {
    SceneTools tools;
    int asked = 0;
    tools.draco = [&](Bytes, std::span<const DracoAttribute>) -> Result<DracoMesh> {
        ++asked;
        return DracoMesh{{std::vector<float>(9)}, {0, 1, 3}};  // a corner too far
    };
    EXPECT_NE(refused_scene(draco_box({0x80, 0x9C, 0x9C, 0x39}).glb(), tools).find("120,000,000"),
              std::string::npos);
    EXPECT_EQ(asked, 0);
    EXPECT_NE(refused_scene(draco_box({1}).glb(), tools).find("damaged"), std::string::npos);
    EXPECT_EQ(asked, 1);
    EXPECT_NE(refused_scene(draco_box({1}).glb(), {}).find("Draco"), std::string::npos);
    GltfBuilder plain = draco_box({1});
    plain.json.erase("extensionsRequired");
    expect_box(read_gltf(plain.glb(), {}));
}

}  // namespace
}  // namespace snug::test
