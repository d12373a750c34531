#pragma once

#include <string>

#include <gtest/gtest.h>

#include "snug/formats/gltf_read.h"
#include "snug/mesh/measure.h"
#include "snug/mesh/mesh.h"
#include "snug/words/words.h"

#include "tests/support/gltf_builder.h"

namespace snug::test {

/// Closed, of 12 triangles, outward, and 120 x 100 x 30 mm: what the box must be however it is written.
inline void expect_box(const Result<Mesh>& mesh) {
    ASSERT_TRUE(mesh.has_value()) << snug::text(mesh.error().message);
    EXPECT_TRUE(mesh->read.in_mm);
    EXPECT_EQ(mesh->triangles.size(), 12U);
    const Vec3d size = bounds(*mesh).size();
    EXPECT_NEAR(size.x, 120, 1e-3);
    EXPECT_NEAR(size.y, 100, 1e-3);
    EXPECT_NEAR(size.z, 30, 1e-3);
    const MeshMeasure measured = measure(*mesh);
    ASSERT_TRUE(measured.volume.has_value());
    EXPECT_NEAR(*measured.volume, 360'000, 1);
}

/// The sentence of a scene that cannot be read.
inline std::string refused_scene(const FileBytes& file, const SceneTools& tools = {}) {
    const auto mesh = read_gltf(file, tools);
    if (mesh) {
        ADD_FAILURE() << "it was read";
        return "";
    }
    EXPECT_EQ(mesh.error().kind, ErrorKind::input);
    return snug::text(mesh.error().message);
}

/// A scene that shows the box once.
inline GltfBuilder box_scene() {
    GltfBuilder scene;
    const GltfBox box;
    const int places = scene.places(box.places), corners = scene.corners(box.corners);
    scene.node({{"mesh", scene.mesh({{"attributes", {{"POSITION", places}}}, {"indices", corners}})}});
    return scene;
}

inline FileBytes file_of(std::string_view text) {
    const auto* begin = reinterpret_cast<const std::byte*>(text.data());
    return {begin, begin + text.size()};
}

}  // namespace snug::test
