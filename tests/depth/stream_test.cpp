#include <algorithm>
#include <atomic>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "snug/formats/mesh_files.h"
#include "snug/formats/read.h"
#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/words/words.h"

#include "tests/support/cases.h"
#include "tests/support/models.h"
#include "tests/support/random_design.h"
#include "tests/support/random_zone.h"
#include "tests/support/streamed_bytes.h"

// Objects that are read in pieces, beside the same objects in memory.

namespace snug {
namespace {

using test::Random;
using test::source_of;
using test::stl_of;

struct Streamed {
    Object object;
    Packing packing;
};

Result<Streamed> pack_stream(TriangleStream stream, const Design& design, const Progress& progress = {}) {
    auto object = prepare(std::move(stream), design, progress);
    if (!object) return tl::unexpected(object.error());
    auto packing = pack(*object, design, progress);
    if (!packing) return tl::unexpected(packing.error());
    return Streamed{std::move(*object), std::move(*packing)};
}

void expect_the_same_zones(const Packing& streamed, const Packing& whole) {
    const auto& zones = whole.items.front().zones;
    ASSERT_EQ(streamed.items.front().zones.size(), zones.size());
    for (std::size_t i = 0; i < zones.size(); ++i)
        EXPECT_EQ(streamed.items.front().zones[i].bounds, zones[i].bounds);
    ASSERT_EQ(streamed.zone_cuts.size(), whole.zone_cuts.size());
    for (std::size_t i = 0; i < whole.zone_cuts.size(); ++i)
        EXPECT_EQ(streamed.zone_cuts[i].blocks, whole.zone_cuts[i].blocks);
}

void expect_the_same_streamed(const FileBytes& bytes, const Design& design) {
    auto mesh = read_mesh(bytes, "object");
    ASSERT_TRUE(mesh) << snug::text(mesh.error().message);
    const auto object = prepare(std::move(*mesh), design);
    const auto stream = TriangleStream::open(source_of(bytes));
    ASSERT_TRUE(stream) << snug::text(stream.error().message);
    const auto streamed = pack_stream(*stream, design);
    if (!object) {
        ASSERT_FALSE(streamed);
        EXPECT_EQ(snug::text(streamed.error().message), snug::text(object.error().message));
        return;
    }
    const auto packing = pack(*object, design);
    ASSERT_EQ(streamed.has_value(), packing.has_value())
        << (streamed ? "" : snug::text(streamed.error().message));
    if (!packing) {
        EXPECT_EQ(snug::text(streamed.error().message), snug::text(packing.error().message));
        return;
    }
    EXPECT_EQ(streamed->object.read.triangles, object->read.triangles);
    const Vec3d size = object->measure.bounds.size();
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(streamed->object.measure.bounds.size()[axis], size[axis], 1e-5 * size[axis] + 1e-9);
    EXPECT_EQ(streamed->packing.items.front().placement.bounds, packing->items.front().placement.bounds);
    EXPECT_EQ(streamed->packing.layers, packing->layers);
    ASSERT_EQ(streamed->packing.foams.has_value(), packing->foams.has_value());
    if (!packing->foams) return;
    EXPECT_EQ(streamed->packing.foams->pieces, packing->foams->pieces);
    EXPECT_EQ(streamed->packing.foams->parting, packing->foams->parting);
    expect_the_same_zones(streamed->packing, *packing);
}

Design random_design_for(Random& random) {
    Design design;
    design.object.units = Unit::mm;
    for (int axis = 0; axis < 3; ++axis) {
        design.placement.rotation_deg[axis] = random.chance(0.3) ? 0 : random.between(-180, 180);
        design.placement.offset_mm[axis] = random.chance(0.5) ? 0 : random.between(-10, 10);
    }
    if (random.chance(0.5)) design.space.blocks.reset();
    if (random.chance(0.3)) design.object.longest_mm = random.between(50, 300);
    if (random.chance(0.3)) design.object.units = Unit::in;
    if (random.chance(0.5)) design.cut.clearance_mm = random.between(-3, 6);
    if (random.chance(0.3)) design.cut.clearance_mm.upper = {random.between(-3, 6), 0, 2};
    return design;
}

TEST(Stream, RandomSoupsHaveTheFoamsThatTheyHaveInMemory) {
    for (int seed = 0; seed < test::cases(60); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        test::RandomDesign soup = test::random_design(random);
        // Survey coordinates are recentred, half of the time.
        if (seed % 2 == 0)
            for (Vec3f& v : soup.mesh.vertices) v = v + Vec3f{5e4f, -3e4f, 2e4f};
        expect_the_same_streamed(stl_of(soup.mesh), random_design_for(random));
    }
}

TEST(Stream, ZonesTakeTheSamePiecesOfTheirTriangles) {
    for (int seed = 0; seed < test::cases(60); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 400);
        test::RandomDesign soup = test::random_design(random);
        if (seed % 2 == 0)
            for (Vec3f& v : soup.mesh.vertices) v = v + Vec3f{5e4f, -3e4f, 2e4f};
        const FileBytes bytes = stl_of(soup.mesh);
        Design design = random_design_for(random);
        design.fit.settle = random.chance(0.5);
        const auto object = prepare(*read_mesh(bytes, "object"), design);
        if (!object) continue;
        for (int i = random.integer(1, 3); i > 0; --i)
            design.protection.zones.push_back(test::random_zone(random, *object));
        // Some hold nothing, others everything: the same is said.
        if (random.chance(0.1)) design.protection.zones.front().balls.front().radius_mm = 1e5;
        if (random.chance(0.1)) design.protection.zones.front().balls = {{{1e6, 0, 0}, 3}};
        expect_the_same_streamed(bytes, design);
    }
}

/// How a PLY may hold its numbers.
struct PlyStyle {
    bool doubles = false, big_endian = false, more = false;
    int index_bytes = 4;
};

class PlyBytes {
  public:
    explicit PlyBytes(const PlyStyle& style) : style_(style) {}

    FileBytes of(const Mesh& mesh, Vec3d far) && {
        const std::string real = style_.doubles ? "double" : "float";
        text("ply\nformat binary_" + std::string(style_.big_endian ? "big" : "little") + "_endian 1.0\n");
        text("element vertex " + std::to_string(mesh.vertices.size() + 1) + "\n");
        if (style_.more) text("property uchar red\n");
        for (const char* axis : {"x", "y", "z"}) text("property " + real + " " + axis + "\n");
        text("element face " + std::to_string(mesh.triangles.size()) + "\n");
        if (style_.more) text("property short flags\n");
        text("property list uchar " + std::string(style_.index_bytes == 2 ? "ushort" : "int") +
             " vertex_indices\n");
        if (style_.more) text("property float quality\nelement edge 1\nproperty int vertex1\n");
        text("end_header\n");
        for (const Vec3f& v : mesh.vertices) vertex(vec_cast<double>(v) + far);
        vertex({1e9, -1e9, 0});  // that no triangle uses
        for (const Triangle& t : mesh.triangles) {
            if (style_.more) number(std::int16_t{7});
            number(std::uint8_t{3});
            for (const std::uint32_t v : t)
                style_.index_bytes == 2 ? number(static_cast<std::uint16_t>(v)) : number(v);
            if (style_.more) number(0.5f);
        }
        if (style_.more) number(std::int32_t{1});
        return std::move(bytes_);
    }

  private:
    void text(const std::string& words) {
        const auto* begin = reinterpret_cast<const std::byte*>(words.data());
        bytes_.insert(bytes_.end(), begin, begin + words.size());
    }
    void vertex(Vec3d p) {
        if (style_.more) number(std::uint8_t{200});
        for (const double value : {p.x, p.y, p.z})
            style_.doubles ? number(value) : number(static_cast<float>(value));
    }
    template <class T>
    void number(T value) {
        std::byte raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        if (style_.big_endian) std::reverse(std::begin(raw), std::end(raw));
        bytes_.insert(bytes_.end(), std::begin(raw), std::end(raw));
    }

    PlyStyle style_;
    FileBytes bytes_;
};

TEST(Stream, RandomPlyFilesHaveTheFoamsThatTheyHaveInMemory) {
    for (int seed = 0; seed < test::cases(60); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const Mesh mesh = test::random_design(random).mesh;
        const PlyStyle style{random.chance(0.5), random.chance(0.3), random.chance(0.5),
                             random.chance(0.3) ? 2 : 4};
        const Vec3d far = random.chance(0.5) ? Vec3d{} : Vec3d{5e5, -3e5, 2e3};
        expect_the_same_streamed(PlyBytes(style).of(mesh, far), random_design_for(random));
    }
}

TEST(Stream, PlyFilesThatCannotBeReadInPiecesSaySo) {
    const auto opened = [](const std::string& text) {
        const auto* begin = reinterpret_cast<const std::byte*>(text.data());
        const FileBytes bytes(begin, begin + text.size());
        const auto stream = TriangleStream::open(source_of(bytes));
        if (!stream) return snug::text(stream.error().message);
        const auto passed = stream->pass([](auto, std::size_t) {});
        return passed ? std::string() : snug::text(passed.error().message);
    };
    const std::string vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const std::string binary = "ply\nformat binary_little_endian 1.0\n";
    const std::string zeros(36, '\0');
    EXPECT_NE(opened("ply\nformat ascii 1.0\n" + vertices + faces + zeros + zeros).find("of text"),
              std::string::npos);
    const auto face = [](char count, char last) {
        return std::string{count, 0, 0, 0, 0, 1, 0, 0, 0, last, 0, 0, 0};
    };
    EXPECT_EQ(opened(binary + vertices + faces + zeros + face(3, 2)), "");
    EXPECT_NE(opened(binary + vertices + faces + zeros + face(3, 3)).find("face 1 wants vertex 3"),
              std::string::npos);
    EXPECT_NE(opened(binary + vertices + faces + zeros + face(4, 2) + zeros).find("4 corners"),
              std::string::npos);
    EXPECT_NE(opened(binary + vertices + faces + zeros).find("too short"), std::string::npos);
    EXPECT_NE(opened(binary + vertices + "end_header\n" + zeros).find("no triangles"), std::string::npos);
    EXPECT_NE(opened(binary + "element vertex 4294967295\nproperty uchar x\n" + faces).find("cut off"),
              std::string::npos);
}

TEST(Stream, SamplesAndSharedObjectsHaveTheFoamsThatTheyHaveInMemory) {
    std::vector<FileBytes> objects;
    for (const std::string_view name : sample_names()) objects.push_back(stl_of(*sample(name)));
    for (const char* name : {"armadillo.obj", "beetle-alt.obj", "camelhead.off", "cow.obj", "screwdriver.off",
                             "spot.obj", "stanford-bunny.obj", "teapot.obj"}) {
        const auto file = test::model_file(name);
        if (!file) continue;
        const auto mesh = read_mesh(*file, name);
        ASSERT_TRUE(mesh);
        objects.push_back(objects.size() % 2 == 0 ? stl_of(*mesh) : PlyBytes({}).of(*mesh, {}));
    }
    Random random(7);
    for (const FileBytes& bytes : objects)
        for (int turn = 0; turn < test::cases_at_most(4); ++turn) {
            SCOPED_TRACE(turn);
            expect_the_same_streamed(bytes, random_design_for(random));
        }
}

TEST(Stream, ReadsTheFileTwice) {
    const FileBytes bytes = stl_of(*sample("figurine"));
    std::atomic<std::uint64_t> read = 0;
    const auto stream = TriangleStream::open(source_of(bytes, &read));
    Design design;
    design.object.units = Unit::mm;
    ASSERT_TRUE(pack_stream(*stream, design));
    EXPECT_LE(read, 2 * bytes.size() + 84);
}

TEST(Stream, IsPackedItselfInWhicheverPlacement) {
    const FileBytes bytes = stl_of(*sample("figurine"));
    Design design;
    design.object.units = Unit::mm;
    auto whole = prepare(*read_mesh(bytes, "object"), design);
    auto streamed = prepare(*TriangleStream::open(source_of(bytes)), design);
    ASSERT_TRUE(whole && streamed);
    for (const Vec3d& rotation : {Vec3d{0, 0, 0}, Vec3d{31, -12, 77}}) {
        design.placement.rotation_deg = rotation;
        const auto expected = pack(*whole, design), got = pack(*streamed, design);
        ASSERT_TRUE(expected && got);
        EXPECT_EQ(got->layers, expected->layers);
        // What it has to be looked at by then changes nothing of it.
        take_stand_in(*streamed);
        EXPECT_FALSE(streamed->mesh.triangles.empty());
    }
}

TEST(Stream, BadFilesAreSentences) {
    const auto opened = [](const FileBytes& bytes) {
        const auto stream = TriangleStream::open(source_of(bytes));
        return stream ? std::string() : snug::text(stream.error().message);
    };
    FileBytes good = stl_of(*sample("torus"));
    EXPECT_EQ(opened(good), "");
    FileBytes cut(good.begin(), good.end() - 70);
    EXPECT_NE(opened(cut).find("cut off"), std::string::npos);
    EXPECT_EQ(opened(cut), snug::text(read_stl(cut).error().message)) << "the same sentence as in memory";
    EXPECT_NE(opened(FileBytes(20)).find("binary STL"), std::string::npos);
    FileBytes none(84);
    EXPECT_NE(opened(none).find("no triangles"), std::string::npos);
    const std::string text =
        "solid thing\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n"
        "   vertex 0 1 0\n  endloop\n endfacet\nendsolid thing\n";
    const auto* begin = reinterpret_cast<const std::byte*>(text.data());
    EXPECT_NE(opened(FileBytes(begin, begin + text.size())).find("--no-stream"), std::string::npos);
}

TEST(Stream, OfTwoElementsOfOneKindNoneIsTakenForTheOther) {
    const std::string element = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    const std::string text = "ply\nformat binary_little_endian 1.0\n" + element + element +
                             "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    FileBytes bytes;
    for (const char c : text) bytes.push_back(static_cast<std::byte>(c));
    bytes.resize(bytes.size() + 2 * 36 + 13, std::byte{3});
    const auto stream = TriangleStream::open(source_of(bytes));
    ASSERT_FALSE(stream);
    EXPECT_NE(snug::text(stream.error().message).find("not the only one of its kind"), std::string::npos)
        << snug::text(stream.error().message);
}

/// Puts what is no place into corners of some of the triangles of a binary STL, or into vertices of a PLY.
FileBytes with_bad_records(FileBytes bytes, std::size_t begin, std::size_t record, std::size_t count,
                           std::size_t floats, double share, Random& random) {
    for (std::size_t r = 0; r < count; ++r) {
        if (!random.chance(share)) continue;
        const float bad = random.chance(0.5) ? std::numeric_limits<float>::quiet_NaN() : -3e38f;
        const std::size_t at = static_cast<std::size_t>(random.integer(0, static_cast<int>(floats) - 1));
        std::memcpy(bytes.data() + begin + r * record + 4 * at, &bad, 4);
    }
    return bytes;
}

TEST(Stream, WhatIsLeftOutInPiecesIsLeftOutInMemory) {
    for (int seed = 0; seed < test::cases(40, 10); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        Mesh mesh = test::random_design(random).mesh;
        if (seed % 2 == 0)
            for (Vec3f& v : mesh.vertices) v = v + Vec3f{5e4f, -3e4f, 2e4f};
        const double share = seed % 10 == 9 ? 0.9 : 0.1;
        const FileBytes stl =
            with_bad_records(stl_of(mesh), 84 + 12, 50, mesh.triangles.size(), 9, share, random);
        PlyStyle style{random.chance(0.5), false, false, 4};
        FileBytes ply = PlyBytes(style).of(mesh, {});
        const std::string_view text(reinterpret_cast<const char*>(ply.data()), ply.size());
        const std::size_t begin = text.find("end_header\n") + 11;
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
            if (!random.chance(0.03)) continue;
            const double none = random.chance(0.5) ? std::numeric_limits<double>::quiet_NaN() : 2e30;
            const auto small = static_cast<float>(none);
            if (style.doubles) std::memcpy(ply.data() + begin + 24 * v + 8, &none, 8);
            if (!style.doubles) std::memcpy(ply.data() + begin + 12 * v + 8, &small, 4);
        }
        const Design design = random_design_for(random);
        for (const FileBytes& bytes : {stl, ply}) {
            const auto whole = read_mesh(bytes, "object");
            const auto stream = TriangleStream::open(source_of(bytes));
            ASSERT_TRUE(stream) << snug::text(stream.error().message);
            const auto streamed = pack_stream(*stream, design);
            if (!whole) {
                ASSERT_FALSE(streamed);
                EXPECT_EQ(snug::text(streamed.error().message), snug::text(whole.error().message));
                continue;
            }
            expect_the_same_streamed(bytes, design);
            if (!streamed) continue;
            EXPECT_EQ(streamed->object.mesh.read.faces, whole->read.faces);
            EXPECT_EQ(streamed->object.mesh.read.left_out_faces, whole->read.left_out_faces);
            const auto told = [](const Finding& finding) { return finding.code() == "left_out"; };
            const auto& findings = streamed->packing.findings;
            EXPECT_EQ(std::any_of(findings.begin(), findings.end(), told),
                      streamed->packing.foams && whole->read.left_out_faces > 0);
        }
    }
}

TEST(Stream, AFileThatShrinksAndACancelledPassEndWithTheirError) {
    const FileBytes bytes = stl_of(*sample("torus"));
    Design design;
    design.object.units = Unit::mm;
    int reads = 0;
    ByteSource shrinking = source_of(bytes);
    const auto whole = shrinking.read;
    shrinking.read = [&](std::uint64_t at, std::span<std::byte> into) -> Result<void> {
        if (++reads > 2) return fail(ErrorKind::input, as_it_is("the file has shrunk"));
        return whole(at, into);
    };
    const auto stream = TriangleStream::open(shrinking);
    const auto packed = pack_stream(*stream, design);
    ASSERT_FALSE(packed);
    EXPECT_EQ(snug::text(packed.error().message), "the file has shrunk");
    const auto again = TriangleStream::open(source_of(bytes));
    const auto cancelled = pack_stream(*again, design, [](double) { return false; });
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().kind, ErrorKind::cancelled);
}

}  // namespace
}  // namespace snug
