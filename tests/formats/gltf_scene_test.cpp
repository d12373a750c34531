#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/words/words.h"

#include "tests/support/gltf_checks.h"

// What a viewer shows when it opens a scene, and where.

namespace snug::test {
namespace {

using Json = nlohmann::json;

/// Each side of the bounding box, rounded to a thousandth of a millimetre.
std::vector<double> size_of(const Result<Mesh>& mesh) {
    EXPECT_TRUE(mesh.has_value()) << text(mesh.error().message);
    if (!mesh) return {};
    const Vec3d size = bounds(*mesh).size();
    return {std::round(size.x * 1000) / 1000, std::round(size.y * 1000) / 1000,
            std::round(size.z * 1000) / 1000};
}

std::size_t triangles_of(const Result<Mesh>& mesh) {
    EXPECT_TRUE(mesh.has_value()) << text(mesh.error().message);
    return mesh ? mesh->triangles.size() : 0;
}

TEST(Gltf, OnlyTheSceneThatAViewerOpensWithIsRead) {
    GltfBuilder scene = box_scene();
    scene.node({{"mesh", 0}, {"translation", {9, 0, 0}}}, false);
    expect_box(read_gltf(scene.glb(), {}));
    scene.json["scenes"].push_back({{"nodes", {1, 0}}});
    expect_box(read_gltf(scene.glb(), {}));
    scene.json["scene"] = 1;
    EXPECT_EQ(size_of(read_gltf(scene.glb(), {})), (std::vector<double>{9120, 100, 30}));
    scene.json.erase("scene");
    scene.json.erase("scenes");
    EXPECT_EQ(triangles_of(read_gltf(scene.glb(), {})), 24U);
}

TEST(Gltf, NodesPlaceWhatLiesInThemAndMirroredOnesStayOutward) {
    GltfBuilder scene = box_scene();
    scene.json["nodes"][0]["scale"] = {-1, 1, 1};
    expect_box(read_gltf(scene.glb(), {}));
    scene.json["nodes"][0] = {{"children", {1}},
                              {"matrix", {0, 0, -.001, 0, 0, .001, 0, 0, .001, 0, 0, 0, 4, 5, 6, 1}}};
    scene.node({{"mesh", 0}, {"scale", {1000, 1000, 1000}}}, false);
    EXPECT_EQ(size_of(read_gltf(scene.glb(), {})), (std::vector<double>{30, 100, 120}));
    // A quarter turn about z; its length does not matter.
    scene.json["nodes"][0] = {{"mesh", 0}, {"rotation", {0, 0, 2, 2}}};
    EXPECT_EQ(size_of(read_gltf(scene.glb(), {})), (std::vector<double>{100, 120, 30}));
}

TEST(Gltf, AHiddenNodeIsNotShown) {
    GltfBuilder scene = box_scene();
    const int below = scene.node({{"mesh", 0}, {"translation", {9, 0, 0}}}, false);
    scene.node({{"children", {below}}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}});
    expect_box(read_gltf(scene.glb(), {}));
}

TEST(Gltf, ANodeWithinItselfOrAtTwoPlacesIsRefused) {
    GltfBuilder scene = box_scene();
    scene.json["nodes"][0]["children"] = {1};
    scene.node({{"children", {0}}}, false);
    EXPECT_NE(refused_scene(scene.glb()).find("within itself"), std::string::npos);

    GltfBuilder two = box_scene();
    const int shared = two.node({{"mesh", 0}}, false);
    two.json["nodes"][0] = {{"children", {shared}}};
    two.node({{"children", {shared}}});
    expect_box(read_gltf(two.glb(), {}));  // where both agree, it is there once
    two.json["nodes"][0]["translation"] = {1, 0, 0};
    EXPECT_NE(refused_scene(two.glb()).find("differently"), std::string::npos);
}

TEST(Gltf, NodesMayNestAsDeepAsTheyLike) {
    GltfBuilder scene = box_scene();
    scene.json["nodes"] = Json::array();
    constexpr int kDepth = 20'000;
    for (int i = 0; i < kDepth; ++i) scene.json["nodes"].push_back({{"children", {i + 1}}});
    scene.json["nodes"].push_back({{"mesh", 0}});
    scene.json["scenes"] = {{{"nodes", {0}}}};
    expect_box(read_gltf(scene.glb(), {}));
}

TEST(Gltf, InstancesAreAllThereAndTooManyAreRefusedBeforeMemoryIsGone) {
    GltfBuilder scene = box_scene();
    const int at = scene.places({0, 0, 0, .2f, 0, 0, 1, 1, 1});
    const int size = scene.places({1, 1, 1, 2, 2, 2, -1, 1, 1});
    const int turn = scene.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1}, 5126, "VEC4", 4);
    const Json attributes{{"TRANSLATION", at}, {"SCALE", size}, {"ROTATION", turn}};
    scene.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
    scene.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    const auto mesh = read_gltf(scene.glb(), {});
    EXPECT_EQ(triangles_of(mesh), 36U);
    const auto volume = measure(*mesh).volume;
    ASSERT_TRUE(volume.has_value());
    EXPECT_NEAR(*volume, 360'000.0 * (1 + 8 + 1), 100);
    auto& accessor = scene.json["accessors"][static_cast<std::size_t>(at)];
    accessor.erase("bufferView");
    accessor["count"] = 4'000'000'000;
    scene.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", at}};
    EXPECT_NE(refused_scene(scene.glb()).find("repeat"), std::string::npos);
}

TEST(Gltf, DefaultMorphWeightsMoveWhatTheyMoveInAViewer) {
    GltfBuilder scene = box_scene();
    std::vector<float> offsets(24, 0);
    for (std::size_t i = 1; i < 8; i += 2) offsets[3 * i] = 0.2f;  // the points at +x
    const int target = scene.places(offsets);
    scene.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", target}}};
    expect_box(read_gltf(scene.glb(), {}));
    scene.json["meshes"][0]["weights"] = {0.5};
    EXPECT_EQ(size_of(read_gltf(scene.glb(), {})), (std::vector<double>{220, 100, 30}));
    scene.json["nodes"][0]["weights"] = {1};
    EXPECT_EQ(size_of(read_gltf(scene.glb(), {})), (std::vector<double>{320, 100, 30}));
}

TEST(Gltf, ASkinStandsWhereItsJointsDo) {
    GltfBuilder scene = box_scene();
    std::vector<std::uint8_t> joints(32, 0);
    std::vector<float> weights(32, 0);
    for (std::size_t i = 0; i < 8; ++i) {
        joints[4 * i + 1] = 1;
        weights[4 * i + (i & 1)] = 0.998f;  // the points at +x hang on the second joint; sums are rounded
    }
    auto& attributes = scene.json["meshes"][0]["primitives"][0]["attributes"];
    const int j = scene.accessor(joints, 5121, "VEC4", 4), w = scene.accessor(weights, 5126, "VEC4", 4);
    attributes["JOINTS_0"] = j;
    attributes["WEIGHTS_0"] = w;
    scene.json["nodes"][0]["translation"] = {50, 50, 50};  // which a skin does not hear
    scene.json["nodes"][0]["skin"] = 0;
    const int second = scene.node({{"translation", {0.1, 0, 0}}}, false);
    const int first = scene.node({{"children", {second}}, {"translation", {3, 0, 0}}});
    scene.json["skins"] = {{{"joints", {first, second}}}};
    const auto stretched = read_gltf(scene.glb(), {});
    EXPECT_EQ(size_of(stretched), (std::vector<double>{220, 100, 30}));
    EXPECT_NEAR(bounds(*stretched).min.x + stretched->origin.x, 3000, 1e-3);
    // Bound where the joints are, nothing moves.
    std::vector<float> inverse(32, 0);
    for (std::size_t m = 0; m < 2; ++m)
        for (std::size_t i = 0; i < 4; ++i) inverse[16 * m + 5 * i] = 1;
    inverse[12] = -3;
    inverse[28] = -3.1f;
    scene.json["skins"][0]["inverseBindMatrices"] = scene.accessor(inverse, 5126, "MAT4", 16);
    expect_box(read_gltf(scene.glb(), {}));
    scene.json["skins"][0]["joints"] = {first};
    EXPECT_NE(refused_scene(scene.glb()).find("joint"), std::string::npos);
}

TEST(Gltf, StripsAndFansAreTheTrianglesThatTheyStandFor) {
    const std::vector<float> square{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    const auto area_of = [&](int mode, const std::vector<std::uint16_t>& corners) {
        GltfBuilder scene;
        const int places = scene.places(square), indices = scene.corners(corners);
        scene.node(
            {{"mesh",
              scene.mesh({{"attributes", {{"POSITION", places}}}, {"indices", indices}, {"mode", mode}})}});
        const auto mesh = read_gltf(scene.glb(), {});
        EXPECT_TRUE(mesh.has_value()) << text(mesh.error().message);
        double sum = 0;
        for (const auto& [a, b, c] : mesh->triangles) {
            const Vec3f p = mesh->vertices[a], q = mesh->vertices[b], r = mesh->vertices[c];
            sum += 0.5e-6 * static_cast<double>((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
        }
        return sum;
    };
    EXPECT_NEAR(area_of(4, {0, 1, 2, 1, 3, 2}), 1, 1e-6);
    EXPECT_NEAR(area_of(5, {0, 1, 2, 3}), 1, 1e-6);
    EXPECT_NEAR(area_of(5, {0, 1, 2, 0xFFFF, 1, 3, 2}), 1, 1e-6);
    EXPECT_NEAR(area_of(6, {0, 1, 3, 2}), 1, 1e-6);
}

TEST(Gltf, LinesAreNoTrianglesAndPointsAloneAreACloud) {
    GltfBuilder scene = box_scene();
    Json& primitive = scene.json["meshes"][0]["primitives"][0];
    primitive["mode"] = 1;
    EXPECT_NE(refused_scene(scene.glb()).find("no triangles"), std::string::npos);
    primitive["mode"] = 0;
    primitive.erase("indices");
    const auto cloud = read_gltf(scene.glb(), {});
    ASSERT_TRUE(cloud.has_value()) << text(cloud.error().message);
    EXPECT_TRUE(cloud->is_cloud());
    EXPECT_TRUE(cloud->read.in_mm);
    EXPECT_EQ(cloud->vertices.size(), 8U);
}

TEST(Gltf, FarFromZeroNoDetailIsLost) {
    GltfBuilder scene = box_scene();
    scene.json["nodes"][0]["translation"] = {450000, 5500000, 120};
    EXPECT_EQ(size_of(read_gltf(scene.glb(), {})), (std::vector<double>{120, 100, 30}));
}

}  // namespace
}  // namespace snug::test
