#include "snug/formats/bundle.h"

#include <string>

#include <gtest/gtest.h>

#include "snug/formats/read_cloud.h"
#include "snug/words/words.h"

#include "cli/inflate.h"
#include "tests/support/read_checks.h"
#include "tests/support/threemf_builder.h"

namespace snug::test {
namespace {

Result<Mesh> read_bundle(const std::string& zip) {
    SceneTools tools;
    tools.inflate = cli::inflate;
    return read_zip(bytes_of(zip), tools, [](Bytes file, std::string_view name, const SceneTools& beside) {
        if (name == "scene.gltf") {  // stands for a reader of scenes, which asks for its buffer
            const auto buffer = beside.beside("a b.bin");
            if (!buffer) return Result<Mesh>(tl::unexpected(buffer.error()));
            return read_obj(*buffer);
        }
        return read_mesh_or_cloud(file, name);
    });
}

const std::string kObj = square_obj("f 1 2 3 4\n");
const std::string kOther = square_obj("f 1 2 3\n");

TEST(Bundle, TheObjectIsFoundAndTheRestIsPassedOver) {
    const Mesh mesh = good(read_bundle(zip_of({{"bust/", ""},
                                               {"__MACOSX/bust/._bust.obj", "fork"},
                                               {"bust/bust.mtl", "newmtl a"},
                                               {"bust/bust.jpg", "picture"},
                                               {"bust/bust.obj", kObj, true}})));
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_TRUE(mesh.read.left_out_objects.empty());
    EXPECT_FALSE(mesh.read.in_mm);
}

TEST(Bundle, ASecondObjectIsLeftOutByName) {
    const Mesh mesh = good(read_bundle(zip_of({{"parts/lid.stl", "x"}, {"a.obj", kObj}, {"b.OBJ", kOther}})));
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.read.left_out_objects, (std::vector<std::string>{"parts/lid.stl", "b.OBJ"}));
}

TEST(Bundle, ASceneTakesWhatLiesBesideItInTheZip) {
    const Mesh mesh =
        good(read_bundle(zip_of({{"a b.bin", "x"}, {"s/scene.gltf", "{}"}, {"s/a b.bin", kObj}})));
    EXPECT_EQ(mesh.triangles.size(), 2u);
    const auto alone = read_bundle(zip_of({{"s/scene.gltf", "{}"}}));
    ASSERT_FALSE(alone);
    expect_holds(snug::text(alone.error().message), "a b.bin");
}

TEST(Bundle, OurOwnPackGivesItsObjectAndNeverAFoam) {
    const std::string project = R"({"snug": 1, "object": {"name": "vase.obj", "bytes": 1, "sha256": ""}})";
    const std::vector<ZipPart> pack = {
        {"lower.obj", kOther}, {"project.snug.json", project}, {"upper.obj", kOther}};
    const auto without = read_bundle(zip_of(pack));
    ASSERT_FALSE(without);
    expect_holds(snug::text(without.error().message), "not their object \"vase.obj\"");
    std::vector<ZipPart> with = pack;
    with.push_back({"vase.obj", kObj});
    const Mesh mesh = good(read_bundle(zip_of(with)));
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_TRUE(mesh.read.left_out_objects.empty());
}

TEST(Bundle, AZippedPackGivesItsProjectWithOrWithoutItsObject) {
    SceneTools tools;
    tools.inflate = cli::inflate;
    const std::string project = R"({"snug": 1, "objects": [{"name": "vase.obj"}, {"name": "lid.obj"}]})";
    std::vector<ZipPart> pack = {{"vase-foam/lower.obj", kOther}, {"vase-foam/project.snug.json", project}};
    const std::string without = zip_of(pack);
    const auto found = find_packed_project(bytes_of(without), tools).value();
    ASSERT_TRUE(found);
    EXPECT_EQ(found->text, project);
    EXPECT_EQ(found->object, "vase.obj");
    EXPECT_FALSE(found->has_object);
    pack.push_back({"vase-foam/vase.obj", kObj});
    const std::string with = zip_of(pack);
    EXPECT_TRUE(find_packed_project(bytes_of(with), tools).value()->has_object);
    const std::string other = zip_of({{"a.obj", kObj}});
    EXPECT_FALSE(find_packed_project(bytes_of(other), tools).value());
    EXPECT_FALSE(find_packed_project(bytes_of(with.substr(0, with.size() / 2)), tools));
}

TEST(Bundle, WhatIsNoProjectBesideAnObjectIsPassedOverAtOnce) {
    const std::string named = R"({"snug": 1, "object": {"name": "lower.obj"}})";
    const auto with = [&](const std::string& project) {
        return good(read_bundle(zip_of({{"a.obj", kObj}, {"a.snug.json", project, true}}))).triangles.size();
    };
    for (const std::string text : {"", "[]", "{\"snug\": 1}", R"({"snug": 1, "object": {"name": 3}})"})
        EXPECT_EQ(with(text), 2u) << text;
    EXPECT_EQ(with(std::string(3'000'000, '[')), 2u);
    EXPECT_EQ(with(named + std::string(4'000'000, ' ')), 2u);  // nobody's project is so large
}

TEST(Bundle, A3mfInAZipIsReadAndAZipInAZipIsNot) {
    const std::string threemf =
        threemf_of(model_of(object_of(1, tetrahedron_mesh("3")), "<item objectid=\"1\"/>"));
    EXPECT_EQ(good(read_bundle(zip_of({{"a.3mf", threemf}}))).triangles.size(), 4u);
    EXPECT_EQ(good(read_bundle(threemf)).triangles.size(), 4u);
    const std::string zip = zip_of({{"a.obj", kObj}});
    for (const char* name : {"a.zip", "a.3mf", "a.stl"})
        EXPECT_FALSE(read_bundle(zip_of({{name, zip}}))) << name;
    const auto nothing = read_bundle(zip_of({{"readme.txt", "x"}}));
    ASSERT_FALSE(nothing);
    expect_holds(snug::text(nothing.error().message), "no object in it");
}

TEST(Bundle, AnErrorNamesTheFileInTheZip) {
    const auto wrong = read_bundle(zip_of({{"folder/a.obj", "v 0 0 0\nf 1 2 3\n"}}));
    ASSERT_FALSE(wrong);
    expect_holds(snug::text(wrong.error().message), "\"folder/a.obj\" in the zip archive: line 2");
}

}  // namespace
}  // namespace snug::test
