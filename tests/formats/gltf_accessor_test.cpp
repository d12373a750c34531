#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/words/words.h"

#include "tests/support/gltf_checks.h"

// Numbers in a scene's bytes: types, scales, strides, replacements, and what they claim.

namespace snug::test {
namespace {

/// The box with its places written as `values` of a component type, and scaled back by its node.
template <class T>
FileBytes quantised(int component, bool normalised, double most) {
    GltfBuilder scene;
    const GltfBox box;
    std::vector<T> values;
    for (std::size_t i = 0; i < box.places.size(); ++i) {
        const double sizes[3] = {1, 1.0 / 1.2, 0.25};
        values.push_back(box.places[i] > 0 ? static_cast<T>(most * sizes[i % 3]) : T{0});
        if (i % 3 == 2) values.push_back(T{0});  // elements begin at multiples of four bytes
    }
    const int places = scene.accessor(values, component, "VEC3", 4);
    scene.json["bufferViews"][0]["byteStride"] = 4 * sizeof(T);
    scene.json["accessors"][0]["normalized"] = normalised;
    const double size = normalised ? most / static_cast<double>(std::numeric_limits<T>::max()) : most;
    const int corners = scene.corners(box.corners);
    const double scale = 0.12 / size;
    scene.node({{"mesh", scene.mesh({{"attributes", {{"POSITION", places}}}, {"indices", corners}})},
                {"scale", {scale, scale, scale}}});
    scene.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    return scene.glb();
}

TEST(Gltf, QuantisedPlacesStandWhereTheyWere) {
    for (const bool normalised : {false, true}) {
        expect_box(read_gltf(quantised<std::int8_t>(5120, normalised, 120), {}));
        expect_box(read_gltf(quantised<std::uint8_t>(5121, normalised, 240), {}));
        expect_box(read_gltf(quantised<std::int16_t>(5122, normalised, 12000), {}));
        expect_box(read_gltf(quantised<std::uint16_t>(5123, normalised, 60000), {}));
    }
}

TEST(Gltf, SparsePlacesReplaceThoseBelowThem) {
    const GltfBox box;
    for (const bool on_top : {false, true}) {
        GltfBuilder scene;
        std::vector<float> base = box.places;
        for (std::size_t i = 12; i < base.size(); ++i) base[i] = 77;  // points 4 to 7 are replaced
        const int below = scene.places(base);
        const std::size_t first = on_top ? 4 : 0;
        std::vector<std::uint16_t> which;
        for (std::size_t i = first; i < 8; ++i) which.push_back(static_cast<std::uint16_t>(i));
        const std::vector<float> values(box.places.begin() + static_cast<std::ptrdiff_t>(3 * first),
                                        box.places.end());
        const int indices = scene.view(which.data(), which.size() * 2);
        const int replaced = scene.view(values.data(), values.size() * 4);
        auto& accessor = scene.json["accessors"][static_cast<std::size_t>(below)];
        accessor["sparse"] = {{"count", which.size()},
                              {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                              {"values", {{"bufferView", replaced}}}};
        if (!on_top) accessor.erase("bufferView");
        const int corners = scene.corners(box.corners);
        scene.node({{"mesh", scene.mesh({{"attributes", {{"POSITION", below}}}, {"indices", corners}})}});
        expect_box(read_gltf(scene.glb(), {}));
    }
}

TEST(Gltf, WithoutIndicesThePointsStandInTheirOrder) {
    GltfBuilder scene;
    const GltfBox box;
    std::vector<float> soup;
    for (const std::uint16_t corner : box.corners)
        soup.insert(soup.end(), box.places.begin() + 3 * corner, box.places.begin() + 3 * corner + 3);
    scene.node({{"mesh", scene.mesh({{"attributes", {{"POSITION", scene.places(soup)}}}})}});
    expect_box(read_gltf(scene.glb(), {}));
}

TEST(Gltf, CountsAreBelievedOnlyAsFarAsThereAreBytes) {
    for (const char* which : {"0", "1"}) {
        GltfBuilder scene = box_scene();
        scene.json["accessors"][which[0] - '0']["count"] = 120'000'000;
        EXPECT_NE(refused_scene(scene.glb()).find("120,000,000"), std::string::npos);
    }
    GltfBuilder nothing = box_scene();
    nothing.json["accessors"][0].erase("bufferView");
    nothing.json["accessors"][0]["count"] = 4'000'000'000;
    EXPECT_NE(refused_scene(nothing.glb()).find("4,000,000,000"), std::string::npos);
    GltfBuilder indices = box_scene();
    indices.json["accessors"][1].erase("bufferView");
    indices.json["accessors"][1]["count"] = 4'000'000'000;
    EXPECT_NE(refused_scene(indices.glb()).find("triangles"), std::string::npos);
}

TEST(Gltf, NumbersThatAreNoneAreLeftOutAndCounted) {
    GltfBuilder scene = box_scene();
    const float none = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(&scene.binary[7 * 12], &none, 4);  // point 7: in four of twelve triangles, or five
    const auto mesh = read_gltf(scene.glb(), {});
    ASSERT_TRUE(mesh.has_value()) << text(mesh.error().message);
    EXPECT_EQ(mesh->read.faces, 12U);
    EXPECT_EQ(mesh->triangles.size() + mesh->read.left_out_faces, 12U);
    EXPECT_GT(mesh->read.left_out_faces, 2U);
    for (std::size_t i = 4; i < 8; ++i) std::memcpy(&scene.binary[i * 12], &none, 4);
    EXPECT_NE(refused_scene(scene.glb()).find("no numbers"), std::string::npos);
}

TEST(Gltf, ManyPartsMayShareOneListOfPoints) {
    GltfBuilder scene;
    const GltfBox box;
    const int places = scene.places(box.places);
    nlohmann::json primitives = nlohmann::json::array();
    for (std::size_t i = 0; i < box.corners.size(); i += 3) {
        const int corners = scene.corners({box.corners[i], box.corners[i + 1], box.corners[i + 2]});
        primitives.push_back({{"attributes", {{"POSITION", places}}}, {"indices", corners}});
    }
    scene.json["meshes"] = {{{"primitives", primitives}}};
    scene.node({{"mesh", 0}});
    const auto mesh = read_gltf(scene.glb(), {});
    expect_box(mesh);
    EXPECT_EQ(mesh->vertices.size(), 36U);
}

}  // namespace
}  // namespace snug::test
