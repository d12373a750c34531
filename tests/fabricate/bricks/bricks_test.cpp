#include "snug/fabricate/bricks/bricks.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>

#include <gtest/gtest.h>

#include "snug/design/presets.h"
#include "snug/formats/read.h"
#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/words/words.h"

#include "tests/support/brick_design.h"
#include "tests/support/heights.h"
#include "tests/support/ldraw_reader.h"
#include "tests/support/models.h"

namespace snug {
namespace {

std::string text_of(const WorkshopPack& pack, const std::string& name) {
    for (const PackFile& file : pack.files)
        if (file.name == name) return {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
    ADD_FAILURE() << "no file " << name;
    return {};
}

struct Size {
    int length, width, plates;
};

/// From what the shops call the parts, not from Snug's table.
const std::map<std::string, Size>& known_parts() {
    static const std::map<std::string, Size> parts{
        {"3006.dat", {10, 2, 3}}, {"3007.dat", {8, 2, 3}},  {"2456.dat", {6, 2, 3}},
        {"3001.dat", {4, 2, 3}},  {"3002.dat", {3, 2, 3}},  {"3003.dat", {2, 2, 3}},
        {"3008.dat", {8, 1, 3}},  {"3009.dat", {6, 1, 3}},  {"3010.dat", {4, 1, 3}},
        {"3622.dat", {3, 1, 3}},  {"3004.dat", {2, 1, 3}},  {"3005.dat", {1, 1, 3}},
        {"3832.dat", {10, 2, 1}}, {"3034.dat", {8, 2, 1}},  {"3795.dat", {6, 2, 1}},
        {"3020.dat", {4, 2, 1}},  {"3021.dat", {3, 2, 1}},  {"3022.dat", {2, 2, 1}},
        {"3460.dat", {8, 1, 1}},  {"3666.dat", {6, 1, 1}},  {"3710.dat", {4, 1, 1}},
        {"3623.dat", {3, 1, 1}},  {"3023.dat", {2, 1, 1}},  {"3024.dat", {1, 1, 1}},
        {"87079.dat", {4, 2, 1}}, {"26603.dat", {3, 2, 1}}, {"3068b.dat", {2, 2, 1}},
        {"4162.dat", {8, 1, 1}},  {"6636.dat", {6, 1, 1}},  {"2431.dat", {4, 1, 1}},
        {"63864.dat", {3, 1, 1}}, {"3069b.dat", {2, 1, 1}}, {"3070b.dat", {1, 1, 1}}};
    return parts;
}

/// How many plates' worth of bricks lie in each block of a half, by j, k and block from the half's floor.
std::map<std::array<int, 3>, int> blocks_of(const std::vector<test::PlacedPart>& parts,
                                            const DesignSpace& space, bool lid) {
    const Vec3i per{static_cast<int>(std::lround(space.block_mm.x / 3.2)),
                    static_cast<int>(std::lround(space.block_mm.y / 8)),
                    static_cast<int>(std::lround(space.block_mm.z / 8))};
    std::map<std::array<int, 3>, int> found;
    for (const test::PlacedPart& part : parts) {
        const auto known = known_parts().find(part.file);
        if (known == known_parts().end()) {
            ADD_FAILURE() << part.file;
            continue;
        }
        const Size size = known->second;
        const auto& m = part.matrix;
        EXPECT_EQ(m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
                      m[2] * (m[3] * m[7] - m[4] * m[6]),
                  1)
            << "mirrored";
        EXPECT_EQ(m[4], 1);
        const bool turned = m[0] == 0;
        const int wide = turned ? size.width : size.length, deep = turned ? size.length : size.width;
        const int left = part.at[0] - 10 * wide, far = part.at[2] + 10 * deep;
        EXPECT_EQ(left % 20, 0);
        EXPECT_EQ(far % 20, 0);
        EXPECT_EQ(part.at[1] % 8, 0);
        for (int column = left / 20; column < left / 20 + wide; ++column)
            for (int row = -far / 20; row < -far / 20 + deep; ++row)
                for (int plate = -part.at[1] / 8 - size.plates; plate < -part.at[1] / 8; ++plate) {
                    // Far to near: j grows in the lower half and falls in the lid.
                    const int j = lid ? space.blocks.y - 1 - row / per.y : row / per.y;
                    ++found[{j, column / per.z, plate / per.x}];
                }
    }
    return found;
}

void expect_the_foam(const WorkshopPack& pack, const DesignSpace& space, const Foams& foams) {
    const test::LdrawModels models = test::read_ldraw(text_of(pack, "bricks/foams.mpd"));
    EXPECT_TRUE(models.ends_in_crlf);
    ASSERT_EQ(models.names.front(), "foams.ldr");
    const int studs = static_cast<int>(std::lround(space.block_mm.x / 3.2) *
                                       std::lround(space.block_mm.y / 8) * std::lround(space.block_mm.z / 8));
    for (const bool lid : {false, true}) {
        const test::Heights kept = test::heights_of(foams, lid ? Half::lid : Half::lower, space.blocks.x);
        const auto model = models.models.find(lid ? "lid.ldr" : "lower.ldr");
        const bool empty = std::all_of(kept.begin(), kept.end(), [](int height) { return height == 0; });
        ASSERT_EQ(model == models.models.end(), empty);
        if (empty) continue;
        const auto found = blocks_of(model->second, space, lid);
        std::size_t wanted = 0;
        for (int j = 0; j < kept.ny(); ++j)
            for (int k = 0; k < kept.nz(); ++k)
                for (int level = 0; level < kept(j, k); ++level, ++wanted) {
                    const auto block = found.find({j, k, level});
                    ASSERT_NE(block, found.end()) << j << " " << k << " " << level;
                    EXPECT_EQ(block->second, studs);
                }
        EXPECT_EQ(found.size(), wanted);
    }
}

void expect_counts(const WorkshopPack& pack) {
    const test::LdrawModels models = test::read_ldraw(text_of(pack, "bricks/foams.mpd"));
    std::map<std::string, int> placed, listed, wanted;
    for (const auto& [name, parts] : models.models)
        if (name != "foams.ldr")
            for (const test::PlacedPart& part : parts)
                ++placed[part.file.substr(0, part.file.size() - 4) + " " + std::to_string(part.color)];
    std::istringstream csv(text_of(pack, "bricks/parts.csv"));
    std::string line;
    std::getline(csv, line);
    EXPECT_EQ(line, "part,name,color,ldraw_color,bricklink_color,pieces");
    while (std::getline(csv, line)) {
        std::vector<std::string> cells;
        std::istringstream split(line);
        for (std::string cell; std::getline(split, cell, ',');) cells.push_back(cell);
        ASSERT_EQ(cells.size(), 6u);
        listed[cells[0] + " " + cells[3]] += std::stoi(cells[5]);
        wanted[cells[0] + " " + cells[4]] += std::stoi(cells[5]);
    }
    EXPECT_EQ(placed, listed);
    const std::string xml = text_of(pack, "bricks/wanted.xml");
    EXPECT_EQ(xml.rfind("<INVENTORY>", 0), 0u);
    const auto field = [&xml](std::size_t from, const std::string& tag) {
        const std::size_t begin = xml.find("<" + tag + ">", from) + tag.size() + 2;
        return xml.substr(begin, xml.find("</", begin) - begin);
    };
    for (std::size_t at = xml.find("<ITEM>"); at != std::string::npos; at = xml.find("<ITEM>", at + 1)) {
        EXPECT_EQ(field(at, "ITEMTYPE"), "P");
        wanted[field(at, "ITEMID") + " " + field(at, "COLOR")] -= std::stoi(field(at, "MINQTY"));
    }
    for (const auto& [item, rest] : wanted) EXPECT_EQ(rest, 0) << item;
}

struct BrickCase {
    Object object;
    Packing packing;
    WorkshopOptions workshop;
    [[nodiscard]] FoamDesign design() const {
        return {packing.space, packing.layers, *packing.foams, packing.available, "vase"};
    }
};

BrickCase packed(Mesh mesh, Vec3i blocks, double diagonal_mm) {
    Design design;
    apply(*find_preset(built_in_presets(), "lego-brick"), design);
    design.space.blocks = blocks;
    design.workshop.work = Workshop::bricks;
    const Vec3d size = bounds(mesh).size();
    design.object.longest_mm = diagonal_mm * std::max({size.x, size.y, size.z}) /
                               std::sqrt(size.x * size.x + size.y * size.y + size.z * size.z);
    design = *checked(design);
    BrickCase result;
    result.object = *prepare(std::move(mesh), design);
    result.packing = *pack(result.object, design);
    result.workshop = design.workshop;
    return result;
}

TEST(BricksTest, TheFilesRebuildTheFoamsOfTheSamples) {
    for (const char* name : {"torus", "vase", "figurine", "camera"})
        for (const BrickRim rim : {BrickRim::studs, BrickRim::tiles}) {
            SCOPED_TRACE(name);
            BrickCase brick = packed(*sample(name), {18, 20, 20}, 100);
            ASSERT_TRUE(brick.packing.foams);
            brick.workshop.bricks.rim = rim;
            const auto pack = brick_pack(brick.design(), brick.workshop, {}, {});
            ASSERT_TRUE(pack) << text(pack.error().message);
            expect_the_foam(*pack, brick.packing.space, *brick.packing.foams);
            expect_counts(*pack);
            const bool gap = std::any_of(pack->findings.begin(), pack->findings.end(),
                                         [](const Finding& each) { return each.code() == "lid_gap"; });
            EXPECT_EQ(gap, rim == BrickRim::studs);
        }
}

TEST(BricksTest, TheFilesRebuildTheFoamsOfRealObjects) {
    int objects = 0;
    for (const char* name : {"stanford-bunny.obj", "armadillo.obj", "spot.obj", "teapot.obj", "cow.obj",
                             "beetle-alt.obj", "camelhead.off", "screwdriver.off"}) {
        const auto bytes = test::model_file(name);
        if (!bytes) continue;
        ++objects;
        SCOPED_TRACE(name);
        BrickCase brick = packed(*read_mesh(*bytes, name), {16, 18, 18}, 110);
        ASSERT_TRUE(brick.packing.foams);
        const auto pack = brick_pack(brick.design(), brick.workshop, {}, {});
        ASSERT_TRUE(pack) << text(pack.error().message);
        expect_the_foam(*pack, brick.packing.space, *brick.packing.foams);
        expect_counts(*pack);
    }
    if (objects == 0) GTEST_SKIP() << "the shared models are not there";
}

TEST(BricksTest, TheFilesRebuildRandomHeightFields) {
    for (int seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(static_cast<std::uint64_t>(seed));
        const test::PrintDesign design = test::random_brick_design(random);
        WorkshopOptions options;
        options.bricks.unit = random.chance(0.5) ? BrickUnit::plate : BrickUnit::automatic;
        options.bricks.rim = random.chance(0.5) ? BrickRim::tiles : BrickRim::studs;
        const auto pack = brick_pack(design.view(), options, {}, {});
        ASSERT_TRUE(pack) << text(pack.error().message);
        expect_the_foam(*pack, design.space, design.foams);
        expect_counts(*pack);
    }
}

TEST(BricksTest, StudsHaveRoomInTheCavity) {
    // A box whose faces lie on block faces: without studs one block more would stay above and below it.
    Design design;
    apply(*find_preset(built_in_presets(), "lego-brick"), design);
    design.workshop.work = Workshop::bricks;
    const Design with = *checked(design);
    design.workshop.work = Workshop::none;
    const Design without = *checked(design);
    EXPECT_DOUBLE_EQ(with.cut.whole_clearance_mm().lower.x - without.cut.whole_clearance_mm().lower.x, 1.8);
    EXPECT_DOUBLE_EQ(with.cut.whole_clearance_mm().upper.x - without.cut.whole_clearance_mm().upper.x, 1.8);
    EXPECT_DOUBLE_EQ(with.cut.whole_clearance_mm().lower.y, without.cut.whole_clearance_mm().lower.y);

    Mesh mesh = *sample("vase");
    const BrickCase brick = packed(mesh, {24, 20, 20}, 120);
    ASSERT_TRUE(brick.packing.foams);
    const Placement& placement = brick.packing.items.front().placement;
    for (const Vec3f& vertex : brick.object.mesh.vertices) {
        const Vec3d p = placement(vertex);
        const DesignSpace& space = brick.packing.space;
        const int j = static_cast<int>(std::floor((p.y - space.face(1, 0)) / space.block_mm.y));
        const int k = static_cast<int>(std::floor((p.z - space.face(2, 0)) / space.block_mm.z));
        const CutRun run = brick.packing.layers.front()(j, k);
        EXPECT_LE(space.face(0, run.first) + kStudHeight, p.x - 1 + 0.011);
        EXPECT_GE(space.face(0, run.end) - kStudHeight, p.x + 1 - 0.011);
    }
}

TEST(BricksTest, AnLIsNotMirrored) {
    // Low foot towards +z at +y in both halves: the reader above finds j and k by the way round of design.md.
    test::Heights lower = test::filled(4, 5, 2), upper = test::filled(4, 5, 2);
    lower(3, 4) = 1;
    upper(0, 1) = 1;
    const test::PrintDesign design({{4, 4, 5}, {9.6, 8, 8}}, lower, upper);
    const auto pack = brick_pack(design.view(), {}, {}, {});
    ASSERT_TRUE(pack);
    expect_the_foam(*pack, design.space, design.foams);
    // The lid lies behind the lower half: BACK edges face each other.
    const test::LdrawModels models = test::read_ldraw(text_of(*pack, "bricks/foams.mpd"));
    ASSERT_EQ(models.models.at("foams.ldr").size(), 2u);
    EXPECT_GT(models.models.at("foams.ldr")[1].at[2], 4 * 20);
}

TEST(BricksTest, WhatCannotBeBuiltIsSaid) {
    const test::PrintDesign design({{4, 4, 5}, {9.6, 8, 8}}, test::filled(4, 5, 2), test::filled(4, 5, 2));
    const auto refusal = [&](auto change) {
        WorkshopOptions options;
        change(options.bricks);
        const auto pack = brick_pack(design.view(), options, {}, {});
        return pack ? std::string() : text(pack.error().message);
    };
    EXPECT_NE(refusal([](BrickOptions& o) { o.family = {"1x1"}; }).find("1x2"), std::string::npos);
    EXPECT_NE(refusal([](BrickOptions& o) { o.family = {"3x3"}; }).find("2x10"), std::string::npos);
    EXPECT_NE(refusal([](BrickOptions& o) { o.lid_color = "pink"; }).find("dark blue"), std::string::npos);
    EXPECT_NE(refusal([](BrickOptions& o) { o.capacity_n = 0; }).find("newtons"), std::string::npos);
    EXPECT_NE(refusal([](BrickOptions& o) { o.stock = {{"2x4", -1}}; }).find("stock"), std::string::npos);
    EXPECT_NE(refusal([](BrickOptions& o) {
                  o.family = {"2x4"};
                  o.stock = {{"2x4", 2}};
              }).find("stock"),
              std::string::npos);
}

TEST(BricksTest, OneLayerIsToldToBeInPieces) {
    const test::PrintDesign design({{2, 20, 20}, {9.6, 8, 8}}, test::filled(20, 20, 1),
                                   test::filled(20, 20, 1));
    const auto pack = brick_pack(design.view(), {}, {}, {});
    ASSERT_TRUE(pack);
    EXPECT_TRUE(std::any_of(pack->findings.begin(), pack->findings.end(),
                            [](const Finding& each) { return each.code() == "brick_pieces"; }));
}

}  // namespace
}  // namespace snug
