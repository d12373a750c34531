#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/words/words.h"

#include "tests/support/gltf_checks.h"

// Scenes that were made to take time or memory: whatever their JSON repeats, work stays in proportion to
// them.

namespace snug::test {
namespace {

using Json = nlohmann::json;

/// Shows its mesh at a thousand nodes.
void repeat_nodes(GltfBuilder& scene) {
    for (int i = 1; i < 1000; ++i) scene.node({{"mesh", 0}});
}

/// The view of the box's places as packed by meshopt, beside which they stand as they are.
void pack_places(GltfBuilder& scene, const Json& packed, std::size_t count) {
    Json& places = scene.json["bufferViews"][0];
    places["extensions"]["EXT_meshopt_compression"] = packed;
    places["extensions"]["EXT_meshopt_compression"].update(
        {{"byteStride", 12}, {"count", count}, {"mode", "ATTRIBUTES"}});
}

TEST(Gltf, ADecoderThatFailsIsNotAskedForTheSameAgain) {
    int asked = 0;
    SceneTools tools;
    tools.meshopt = [&](Bytes, const MeshoptView&) -> Result<FileBytes> {
        ++asked;
        return fail(ErrorKind::input, as_it_is("damaged"));
    };
    tools.draco = [&](Bytes, std::span<const DracoAttribute>) -> Result<DracoMesh> {
        ++asked;
        return fail(ErrorKind::input, as_it_is("damaged"));
    };
    GltfBuilder meshopt = box_scene();
    const std::vector<std::uint8_t> packed(64, 0xA0);
    const auto view = static_cast<std::size_t>(meshopt.view(packed.data(), packed.size()));
    const Json where = meshopt.json["bufferViews"][view];
    pack_places(meshopt, where, 8);
    repeat_nodes(meshopt);
    const auto plain = read_gltf(meshopt.glb(), tools);
    ASSERT_TRUE(plain.has_value()) << snug::text(plain.error().message);
    EXPECT_EQ(plain->triangles.size(), 12'000U);
    EXPECT_EQ(asked, 1);

    asked = 0;
    GltfBuilder draco = box_scene();
    const std::string text = std::string("DRACO\2\2\1\0\0\0\x0C", 12) + std::string(20, '\0');
    const int bytes = draco.view(text.data(), text.size());
    draco.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", bytes}, {"attributes", {{"POSITION", 0}}}};
    repeat_nodes(draco);
    EXPECT_TRUE(read_gltf(draco.glb(), tools).has_value());
    EXPECT_EQ(asked, 1);
}

TEST(Gltf, ViewsThatShareTheirPackedBytesAreTriedWithinABudget) {
    std::size_t unpacked = 0;
    SceneTools tools;
    tools.meshopt = [&](Bytes, const MeshoptView& view) -> Result<FileBytes> {
        unpacked += view.count * view.stride;
        return fail(ErrorKind::input, as_it_is("damaged at its end"));
    };
    GltfBuilder scene;
    const GltfBox box;
    const std::vector<std::uint8_t> packed(100'000, 0xA0);
    const int hidden = scene.view(packed.data(), packed.size());
    const Json where = scene.json["bufferViews"][static_cast<std::size_t>(hidden)];
    const int corners = scene.corners(box.corners);
    for (int i = 0; i < 100; ++i) {
        const int places = scene.places(box.places);
        Json& view = scene.json["bufferViews"].back();
        view["extensions"]["EXT_meshopt_compression"] = where;
        view["extensions"]["EXT_meshopt_compression"].update(
            {{"byteStride", 12}, {"count", 500'000}, {"mode", "ATTRIBUTES"}});
        scene.node({{"mesh", scene.mesh({{"attributes", {{"POSITION", places}}}, {"indices", corners}})}});
    }
    const FileBytes file = scene.glb();
    EXPECT_TRUE(read_gltf(file, tools).has_value());
    EXPECT_LE(unpacked, 16'000'000 + 64 * (file.size() + packed.size()));
}

TEST(Gltf, WhatMeshoptPackedBesideASmallSceneMayBeLarge) {
    constexpr std::size_t kPoints = 2'000'000;
    GltfBuilder scene;
    const std::vector<std::uint8_t> packed(600'000, 0xA0);
    const int view = scene.view(packed.data(), packed.size());
    const Json where = scene.json["bufferViews"][static_cast<std::size_t>(view)];
    pack_places(scene, where, kPoints);
    scene.json["accessors"] = {
        {{"bufferView", 0}, {"componentType", 5126}, {"count", kPoints}, {"type", "VEC3"}}};
    const int corners = scene.corners({0, 1, 2});
    scene.node({{"mesh", scene.mesh({{"attributes", {{"POSITION", 0}}}, {"indices", corners}})}});
    SceneTools tools;
    tools.beside = [&](const std::string&) -> Result<FileBytes> { return scene.binary; };
    tools.meshopt = [](Bytes, const MeshoptView& packed_view) -> Result<FileBytes> {
        FileBytes bytes(packed_view.count * packed_view.stride);
        bytes[15] = bytes[28] = std::byte{0x40};  // (2, 0, 0) and (0, 2, 0)
        bytes[31] = std::byte{0x40};
        return bytes;
    };
    const auto mesh = read_gltf(file_of(scene.gltf("scene.bin")), tools);
    EXPECT_TRUE(mesh.has_value()) << snug::text(mesh.error().message);
}

TEST(Gltf, WeightsAndShapesOfManyNodesAreReadWithinABudget) {
    GltfBuilder weights = box_scene();
    weights.json["meshes"][0]["weights"] = std::vector<int>(20'000, 0);
    expect_box(read_gltf(weights.glb(), {}));
    repeat_nodes(weights);
    EXPECT_NE(refused_scene(weights.glb()).find("repeats"), std::string::npos);

    GltfBuilder shapes = box_scene();
    shapes.json["nodes"][0]["weights"] = std::vector<int>(20'000, 0);
    Json& primitives = shapes.json["meshes"][0]["primitives"];
    primitives[0]["targets"] = std::vector<Json>(20'000, Json::object());
    expect_box(read_gltf(shapes.glb(), {}));
    shapes.json["meshes"][0]["weights"] = std::vector<int>(20'000, 0);
    repeat_nodes(shapes);
    EXPECT_NE(refused_scene(shapes.glb()).find("repeats"), std::string::npos);
}

TEST(Gltf, SparseShapesCountForTheSearchesThatTheyAre) {
    GltfBuilder scene = box_scene();
    const std::vector<std::uint8_t> which{1, 3};
    const std::vector<float> offsets{1, 0, 0, 1, 0, 0};
    const int indices = scene.view(which.data(), 2), values = scene.view(offsets.data(), 24);
    scene.json["accessors"].push_back({{"componentType", 5126},
                                       {"count", 8},
                                       {"type", "VEC3"},
                                       {"sparse",
                                        {{"count", 2},
                                         {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                                         {"values", {{"bufferView", values}}}}}});
    scene.json["accessors"].push_back({{"componentType", 5126}, {"count", 60'000}, {"type", "VEC3"}});
    scene.json["meshes"][0]["weights"] = {1, 1, 1, 1};
    scene.json["meshes"][0]["primitives"][0]["targets"] = std::vector<Json>(4, {{"POSITION", 2}});
    EXPECT_TRUE(read_gltf(scene.glb(), {}).has_value());
    scene.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", 3}};
    EXPECT_NE(refused_scene(scene.glb()).find("mixed"), std::string::npos);
}

}  // namespace
}  // namespace snug::test
