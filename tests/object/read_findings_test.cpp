#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "snug/design/project.h"
#include "snug/formats/read_cloud.h"
#include "snug/make.h"
#include "snug/words/words.h"

#include "tests/support/read_checks.h"

// What a reader noted reaches the person who packs.

namespace snug {
namespace {

using test::bytes_of;
using test::good;

/// The severity of a finding; none where there is none of this code.
std::optional<Severity> told(const std::string& file, const std::string& code) {
    Design design;
    design.object.units = Unit::mm;
    const auto object = prepare(good(read_mesh_or_cloud(bytes_of(file), "a.xyz")), design);
    EXPECT_TRUE(object) << snug::text(object.error().message);
    const auto packing = pack(*object, design);
    EXPECT_TRUE(packing && packing->foams);
    for (const Finding& finding : packing->findings)
        if (finding.code() == code) return finding.severity;
    return {};
}

TEST(ReadFindings, WhatIsLeftOutIsToldAndIsADangerAboveOnePercent) {
    for (const int good_ones : {98, 99, 100, 300}) {
        SCOPED_TRACE(good_ones);
        const Severity expected = good_ones + 1 < 100 ? Severity::danger : Severity::warning;
        std::string mesh = "v 0 0 0\nv 50 0 0\nv 0 50 0\nv 0 0 50\nf 1 2\n", cloud = "nan nan nan\n";
        for (int i = 0; i < good_ones; ++i) {
            mesh += "f 1 2 3\n";
            cloud +=
                std::to_string(i % 10) + " " + std::to_string(i / 10) + " " + std::to_string(i % 7) + "\n";
        }
        EXPECT_EQ(told(mesh, "left_out"), expected);
        EXPECT_EQ(told(cloud, "left_out"), expected);
    }
    EXPECT_EQ(told("v 0 0 0\nv 50 0 0\nv 0 50 0\nf 1 2 3\n", "left_out"), std::nullopt);
    const std::string stl =
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 50 0 0\nvertex 0 50 9\n"
        "endloop\nendfacet\n";
    EXPECT_EQ(told(stl, "no_end"), Severity::warning);
    EXPECT_EQ(told(stl + "endsolid\n", "no_end"), std::nullopt);
}

TEST(ReadFindings, AFileThatStatesItsUnitIsNotMultipliedByAnother) {
    Mesh mesh = test::tetrahedron();
    mesh.read.in_mm = true;
    for (const auto units : {std::optional<Unit>(), std::optional(Unit::mm), std::optional(Unit::in)}) {
        Design design;
        design.object.units = units;
        const auto object = prepare(mesh, design);
        ASSERT_TRUE(object);
        EXPECT_EQ(object->measure.bounds.size(), (Vec3d{60, 60, 60}));
        const auto packing = pack(*object, design);
        ASSERT_TRUE(packing);
        bool warned = false;
        for (const Finding& finding : packing->findings) warned |= finding.code() == "unit_stated";
        EXPECT_EQ(warned, units == Unit::in);
        design.object.scale = 0.5;
        EXPECT_EQ(prepare(mesh, design)->measure.bounds.size(), (Vec3d{30, 30, 30}));
        design.object.longest_mm = 90;
        EXPECT_EQ(prepare(mesh, design)->measure.bounds.size(), (Vec3d{90, 90, 90}));
    }
    // 6 mm, as the file says: no one need be asked.
    for (Vec3f& v : mesh.vertices) v = v * 0.1f;
    EXPECT_TRUE(prepare(mesh, {}));
    mesh.read.in_mm = false;
    EXPECT_FALSE(prepare(mesh, {}));
}

TEST(ReadFindings, AProjectInUtf16IsTheSameProject) {
    Project project;
    project.objects.front().file = {"a.stl", 7, ""};
    const std::string text = project_json(project);
    for (const bool big : {false, true}) {
        const auto read = parse_project(test::utf16(text, big, true));
        ASSERT_TRUE(read) << snug::text(read.error().message);
        EXPECT_EQ(read->objects.front().file.name, "a.stl");
    }
}

}  // namespace
}  // namespace snug
