#include "snug/fabricate/mould/mould.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/formats/read.h"
#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/solid/solid.h"
#include "snug/words/words.h"

#include "tests/support/assembled_mould.h"
#include "tests/support/cases.h"
#include "tests/support/models.h"
#include "tests/support/print_design.h"
#include "tests/support/printed_checks.h"

namespace snug {
namespace {

using test::AssembledMould;
using test::Heights;

constexpr const char* kHalves[] = {"lower", "lid"};

Heights foam_of(const FoamDesign& design, const std::string& half) {
    return test::heights_of(design.foams, half == "lower" ? Half::lower : Half::lid, design.space.blocks.x);
}

int greatest(const Heights& heights) {
    return *std::max_element(heights.begin(), heights.end());
}

/// Where a half's place (levels from its outer side, j and k in blocks) lies in its assembled mould: cavity
/// down, k to the right; BACK, where j is least, to the front for the lower half and to the back for the lid.
Vec3d in_mould(Vec3d blocks, const Heights& foam, Vec3d s, const std::string& half, double wall) {
    const double y = half == "lower" ? blocks.y : foam.ny() - blocks.y;
    return {wall + blocks.z * s.z, wall + y * s.y, wall + (greatest(foam) - blocks.x) * s.x};
}

/// The blocks that can be poured: the mould's complement, asked along a line through each column.
Heights poured_blocks(const AssembledMould& mould, const Heights& foam, Vec3d s, const std::string& half,
                      double wall) {
    Heights poured(foam.ny(), foam.nz());
    for (int j = 0; j < foam.ny(); ++j)
        for (int k = 0; k < foam.nz(); ++k) {
            const auto place = [&](int i) {
                return in_mould({i + 0.487, j + 0.513, k + 0.479}, foam, s, half, wall);
            };
            const auto crossings = mould.crossings(place(0).x, place(0).y);
            for (int i = 0; i < greatest(foam); ++i) {
                int turns = 0;
                for (const auto& [z, way] : crossings) turns += z < place(i).z ? way : 0;
                EXPECT_TRUE(turns == 0 || turns == 1);
                if (turns == 0) ++poured(j, k);
            }
        }
    return poured;
}

double plastic_of(const AssembledMould& mould) {
    double volume = 0;
    for (const auto& part : mould.parts) volume += test::signed_volume(part.vertices, part.triangles);
    return volume;
}

void expect_drained(const test::PrintedItem& part) {
    for (const Triangle& t : part.triangles) {
        const Vec3d a = vec_cast<double>(part.vertices[t[0]]), b = vec_cast<double>(part.vertices[t[1]]),
                    c = vec_cast<double>(part.vertices[t[2]]);
        const Vec3d normal = cross(b - a, c - a);
        ASSERT_GT(dot(normal, normal), 0) << part.name;
        if (normal.z < -1e-9) {
            ASSERT_EQ(std::max({a.z, b.z, c.z}), test::bounds_of(part).min.z) << part.name;
        }
    }
}

/// All that must hold for a design's moulds without draft and dowels: closed, drained, and their complement
/// is the foam.
void expect_moulds_of(const FoamDesign& design, WorkshopOptions options) {
    options.mould.draft_deg = 0;
    options.print.dowels = false;
    const auto pack = mould_pack(design, options);
    ASSERT_TRUE(pack.has_value()) << text(pack.error().message);
    const MouldOptions& m = options.mould;
    const Vec3d s = design.space.block_mm;
    for (const std::string half : kHalves) {
        SCOPED_TRACE(half);
        const Heights foam = foam_of(design, half);
        const long long blocks = std::accumulate(foam.begin(), foam.end(), 0LL);
        if (blocks == 0) continue;
        const AssembledMould mould = test::assembled_mould(*pack, half);
        for (const auto& part : mould.parts) {
            // Welded by place, edges that touch may have two pairs of triangles.
            EXPECT_TRUE(test::closed_when_welded(part.vertices, part.triangles));
            expect_drained(part);
        }
        EXPECT_EQ(poured_blocks(mould, foam, s, half, m.wall_mm), foam);
        const double pour_height = m.wall_mm + greatest(foam) * s.x;
        const Vec3d size = mould.box.size();
        EXPECT_NEAR(size.x, foam.nz() * s.z + 2 * m.wall_mm, 0.01);
        EXPECT_NEAR(size.y, foam.ny() * s.y + 2 * m.wall_mm, 0.01);
        EXPECT_NEAR(size.z, pour_height + m.rim_mm, 0.01);
        const double below =
            size.x * size.y * pour_height - static_cast<double>(blocks) * design.space.block_volume();
        const double rim =
            plastic_of(mould) - below;  // a ring thinner than the wall, without its marked corner
        EXPECT_GE(rim, -1e-3 * below);
        EXPECT_LE(rim, m.rim_mm * 2 * m.wall_mm * (size.x + size.y) + 1e-3 * below);
    }
}

WorkshopOptions random_options(test::Random& random) {
    WorkshopOptions options;
    options.print = test::random_print_options(random);
    options.mould.wall_mm = random.between(0.4, 6);
    options.mould.rim_mm = random.chance(0.2) ? 0 : random.between(0, 10);
    options.mould.draft_deg = random.between(0, 15);
    return options;
}

TEST(MouldPack, TheComplementOfRandomMouldsOnAnyBedIsTheFoam) {
    int packs = 0;
    const int seeds = test::cases(60, 15);
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(seeds); ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const test::PrintDesign design = test::random_print_design(random);
        const WorkshopOptions options = random_options(random);
        if (!mould_pack(design.view(), options)) continue;
        expect_moulds_of(design.view(), options);
        ++packs;
    }
    EXPECT_GT(packs, seeds / 3);
}

/// With draft and dowels: what comes out of the mould is never more than the half, the mould never less than
/// without draft, every part closed, on its bed and apart from the others.
TEST(MouldPack, DraftedFoamNeverExceedsTheHalf) {
    int packs = 0, points = 0;
    const int seeds = test::cases(60, 15);
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(seeds); ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const test::PrintDesign design = test::random_print_design(random);
        WorkshopOptions options = random_options(random);
        const auto pack = mould_pack(design.view(), options);
        if (!pack) {
            EXPECT_FALSE(text(pack.error().message).empty());
            continue;
        }
        ++packs;
        for (const PackContainer& container : pack->containers) {
            const auto items = test::read_printed(container);
            test::expect_on_bed(items, options.print.bed_mm);
            for (const auto& item : items) test::expect_closed(item);
        }
        options.print.dowels = false;  // bores are neither foam nor plastic
        const auto whole = mould_pack(design.view(), options);
        for (const std::string half : kHalves) {
            const Heights foam = foam_of(design.view(), half);
            if (greatest(foam) == 0) continue;
            const AssembledMould mould = test::assembled_mould(*whole, half);
            for (const auto& part : mould.parts) expect_drained(part);
            for (int i = 0; i < 60; ++i, ++points) {
                const Vec3d at{random.between(0, greatest(foam)), random.between(0, foam.ny()),
                               random.between(0, foam.nz())};
                const int turns =
                    mould.winding(in_mould(at, foam, design.space.block_mm, half, options.mould.wall_mm));
                ASSERT_TRUE(turns == 0 || turns == 1);
                if (turns == 0) {
                    ASSERT_LT(at.x, foam(static_cast<int>(at.y), static_cast<int>(at.z)) + 1e-3);
                }
            }
        }
    }
    EXPECT_GT(packs, seeds / 3);
    EXPECT_GT(points, seeds * 33);
}

/// An L in a full frame, so that each mirror image differs. The foam is taken out of its mould, turned over
/// by half a turn, and laid into the design: there it must be the half's own solid.
TEST(MouldPack, AnLTakenOutAndTurnedOverIsTheHalf) {
    const DesignSpace space{{6, 7, 8}, {5, 6, 7}};
    Heights lower = test::filled(7, 8, 3), upper = test::filled(7, 8, 3);
    for (int j = 1; j < 6; ++j) lower(j, 1) = upper(j, 1) = 1;
    for (int k = 1; k < 5; ++k) lower(5, k) = upper(5, k) = 2;
    const test::PrintDesign design(space, lower, upper);
    WorkshopOptions options;
    options.mould.draft_deg = 0;
    const auto pack = mould_pack(design.view(), options);
    ASSERT_TRUE(pack.has_value());
    for (const std::string half : kHalves) {
        const AssembledMould mould = test::assembled_mould(*pack, half);
        const Solid solid =
            half == "lower" ? lower_solid(design.foams, space) : upper_solid(design.foams, space);
        const test::PrintedItem expected{half, solid.vertices, solid.triangles};
        const Vec3d middle = mould.box.centre();
        const double wall = options.mould.wall_mm, top = wall + 3 * space.block_mm.x;
        int foam = 0;
        for (double x = -27.1237; x < 28; x += 1.317)
            for (double y = -20.3391; y < 21; y += 1.733)
                for (double z = wall + 0.11; z < top; z += 1.1) {
                    // From the middle of the mould, and turned over about its left-right axis; the rim of the
                    // cavity, on the mould's floor, is the parting, which is x = 0.
                    const Vec3d turned{x, -y, -(z - wall)};
                    // Cavity up, from +x: k (design z) to the right, j (y) to the front, x upward; from -x: z
                    // to the right, y to the back, x downward. Both are turns, not reflections.
                    const bool is_lower = half == "lower";
                    const Vec3d p{is_lower ? turned.z : -turned.z, is_lower ? -turned.y : turned.y, turned.x};
                    const int plastic = mould.winding({middle.x + x, middle.y + y, z});
                    ASSERT_EQ(test::winding(expected, p), 1 - plastic)
                        << half << " " << x << " " << y << " " << z;
                    foam += 1 - plastic;
                }
        EXPECT_GT(foam, 1000);
    }
}

TEST(MouldPack, TheRimIsMissingAtColumnA1OnlyAndAlwaysAtBack) {
    const test::PrintDesign design({{4, 9, 9}, {10, 10, 10}}, test::filled(9, 9, 2), test::filled(9, 9, 2));
    const auto pack = mould_pack(design.view(), {});
    for (const std::string half : kHalves) {
        const AssembledMould mould = test::assembled_mould(*pack, half);
        const auto top = [&](bool right, bool back) {
            const Vec3d size = mould.box.size();
            return mould.crossings(right ? size.x - 0.3 : 0.3, back ? size.y - 0.31 : 0.31).back().first;
        };
        const bool back = half == "lid";
        EXPECT_NEAR(top(false, back), 23, 1e-3);
        EXPECT_NEAR(top(false, !back), 28, 1e-3);
        EXPECT_NEAR(top(true, back), 28, 1e-3);
        EXPECT_NEAR(top(true, !back), 28, 1e-3);
    }
}

Design sample_design(double side, Vec3i blocks) {
    Design design;
    design.object.units = Unit::mm;
    design.space.blocks = blocks;
    design.space.block_mm = {side / blocks.x, side / blocks.y, side / blocks.z};
    design.placement.rotation_deg = {10, 20, 30};
    return design;
}

void expect_moulds_of(const Mesh& mesh, const Design& design) {
    const auto object = prepare(mesh, design);
    ASSERT_TRUE(object.has_value());
    const auto packing = pack(*object, design);
    ASSERT_TRUE(packing && packing->foams);
    const FoamDesign foams{packing->space, packing->layers, *packing->foams, packing->available, "object"};
    WorkshopOptions options;
    expect_moulds_of(foams, options);
    const auto pack = mould_pack(foams, options);
    for (const PackContainer& container : pack->containers)
        for (const auto& item : test::read_printed(container)) test::expect_closed(item);
}

TEST(MouldPack, TheComplementOfTheSamplesMouldsIsTheirFoam) {
    for (const char* name : {"torus", "vase", "figurine", "camera"}) {
        SCOPED_TRACE(name);
        expect_moulds_of(*sample(name), sample_design(360, {22, 20, 24}));
    }
}

TEST(MouldPack, TheComplementOfTheModelsMouldsIsTheirFoam) {
    for (const char* name :
         {"stanford-bunny.obj", "armadillo.obj", "spot.obj", "teapot.obj", "screwdriver.off"}) {
        SCOPED_TRACE(name);
        const auto bytes = test::model_file(name);
        if (!bytes) GTEST_SKIP() << "the shared models are not here";
        Mesh mesh = read_mesh(*bytes, name).value();
        const Vec3d size = bounds(mesh).size();
        expect_moulds_of(scaled(std::move(mesh), 240 / std::sqrt(dot(size, size))),
                         sample_design(324, {20, 20, 20}));
    }
}

}  // namespace
}  // namespace snug
