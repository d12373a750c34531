#include <string>

#include <gtest/gtest.h>

#include "tests/support/gltf_checks.h"

// What surrounds a scene: chunks, text, files beside it, extensions.

namespace snug::test {
namespace {

TEST(Gltf, APaddedAndAnUnpaddedGlbAreTheSame) {
    GltfBuilder scene = box_scene();
    expect_box(read_gltf(scene.glb(), {}));
    // Every remainder by four, since the text's length decides where the next chunk begins.
    for (int i = 0; i < 4; ++i) {
        scene.json["asset"]["generator"] = std::string(static_cast<std::size_t>(i), 'x');
        expect_box(read_gltf(scene.glb(false), {}));
    }
}

TEST(Gltf, ATotalLengthThatIsWrongIsPassedOver) {
    for (const std::byte wrong : {std::byte{0}, std::byte{0xFF}}) {
        FileBytes file = box_scene().glb();
        for (std::size_t i = 8; i < 12; ++i) file[i] = wrong;
        expect_box(read_gltf(file, {}));
    }
}

TEST(Gltf, TextMayBeginWithAByteOrderMarkAndHoldNamesThatAreNoUtf8) {
    const GltfBuilder scene = box_scene();
    SceneTools tools;
    tools.beside = [&](const std::string&) { return Result<FileBytes>(scene.binary); };
    expect_box(read_gltf(file_of("\xEF\xBB\xBF" + scene.gltf("a.bin")), tools));
    GltfBuilder named = scene;
    named.json["nodes"][0]["name"] = "Flasche";
    std::string text = named.gltf("a.bin");
    text.replace(text.find("Flasche"), 7, "Fl\xE4sch\xE9");
    expect_box(read_gltf(file_of(text), tools));
}

TEST(Gltf, NamesOfFilesAreDecodedAndDataMayStandInTheText) {
    const GltfBuilder scene = box_scene();
    SceneTools tools;
    tools.beside = [&](const std::string& name) -> Result<FileBytes> {
        if (name != "my scan \xC3\xA4.bin" && name != "100%.bin" && name != "%41.bin")
            return fail(ErrorKind::input, as_it_is("not there: " + name));
        return scene.binary;
    };
    expect_box(read_gltf(file_of(scene.gltf("my%20scan%20%C3%A4.bin")), tools));
    expect_box(read_gltf(file_of(scene.gltf("100%.bin")), tools));
    expect_box(read_gltf(file_of(scene.gltf("%41.bin")), tools));  // as it stands, where "A.bin" is not there
    std::string hex = "data:,";
    for (const std::byte each : scene.binary) {
        static constexpr char kDigits[] = "0123456789abcdef";
        hex += '%';
        hex += kDigits[std::to_integer<unsigned>(each) >> 4];
        hex += kDigits[std::to_integer<unsigned>(each) & 15];
    }
    expect_box(read_gltf(file_of(scene.gltf(hex)), {}));
}

TEST(Gltf, WhatLiesElsewhereIsRefusedByItsName) {
    SceneTools tools;
    tools.beside = [](const std::string&) -> Result<FileBytes> { return FileBytes(1000); };
    for (const char* uri : {"https://example.com/a.bin", "/etc/passwd", "file:///a.bin"})
        EXPECT_NE(refused_scene(file_of(box_scene().gltf(uri)), tools).find(uri), std::string::npos);
    EXPECT_NE(refused_scene(file_of(box_scene().gltf("a.bin"))).find("a.bin"), std::string::npos);
}

TEST(Gltf, ARequiredExtensionThatMayChangeTheShapeIsRefusedByItsName) {
    for (const char* name : {"KHR_meshopt_compression", "VENDOR_bent_space", "KHR_gaussian_splatting"}) {
        GltfBuilder scene = box_scene();
        scene.json["extensionsRequired"] = {name};
        EXPECT_NE(refused_scene(scene.glb()).find(name), std::string::npos);
        scene.json["extensionsUsed"] = {name};
        scene.json.erase("extensionsRequired");
        expect_box(read_gltf(scene.glb(), {}));
    }
}

TEST(Gltf, LooksAreNoReasonToRefuse) {
    for (const char* name : {"KHR_texture_basisu", "KHR_materials_unlit", "KHR_texture_transform",
                             "KHR_lights_punctual", "EXT_texture_webp", "KHR_mesh_quantization"}) {
        GltfBuilder scene = box_scene();
        scene.json["extensionsRequired"] = {name};
        scene.json["images"] = {{{"uri", "not-there.ktx2"}}};
        expect_box(read_gltf(scene.glb(), {}));
    }
}

TEST(Gltf, DamagedFilesSayWhatIsWrong) {
    const FileBytes file = box_scene().glb();
    for (std::size_t size = 0; size < file.size(); ++size)
        EXPECT_FALSE(read_gltf(Bytes(file).first(size), {}).has_value()) << size;
    EXPECT_NE(refused_scene(file_of(R"({"asset":{"version":"1.0"}})")).find("version"), std::string::npos);
    EXPECT_NE(refused_scene(file_of(std::string(1'000'000, '['))).find("nests"), std::string::npos);
    EXPECT_NE(refused_scene(file_of(R"({"asset":{"version":"2.0"}})")).find("no triangles"),
              std::string::npos);
}

}  // namespace
}  // namespace snug::test
