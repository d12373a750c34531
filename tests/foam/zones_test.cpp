#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "snug/foam/zone_cuts.h"
#include "snug/make.h"
#include "snug/object/zone_surface.h"
#include "snug/samples/samples.h"
#include "snug/space/place_zones.h"

#include "tests/support/broken_foams.h"
#include "tests/support/brute_force.h"
#include "tests/support/cases.h"
#include "tests/support/fit_designs.h"
#include "tests/support/random.h"
#include "tests/support/random_design.h"
#include "tests/support/random_zone.h"
#include "tests/support/shapes.h"
#include "tests/support/zoned_kit.h"

// Places on an item that foam keeps away from.

namespace snug {
namespace {

using test::Random;

TEST(Zones, AreFreeAllRoundAndOnTheWayInAndOutOfEveryPiece) {
    int looked_at = 0, trays = 0, layered = 0;
    const int kits = test::cases(160, 30);
    for (int seed = 0; seed < kits; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 91000);
        const test::ZonedKit kit = test::random_kit_with_zones(random);
        const auto design = checked(kit.design);
        ASSERT_TRUE(design) << text(design.error().message);
        const auto packing = pack(kit.objects, *design);
        if (!packing || !packing->foams) continue;  // a zone that holds a whole soup
        trays += packing->foams->open();
        layered += packing->foams->layers() > 1;
        for (const Item& item : packing->items)
            for (const ItemZone& zone : item.zones)
                for (int i = 0; i < 300; ++i) {
                    const Object& object = kit.objects[item.object];
                    const Vec3d p = test::point_of(random, object.mesh);
                    if (!test::is_in(zone.asked, p + object.mesh.origin)) continue;
                    ++looked_at;
                    const Vec3d placed = item.placement(vec_cast<float>(p));
                    for (std::size_t piece = 0; piece < packing->foams->pieces.size(); ++piece)
                        ASSERT_FALSE(test::stands_in_the_way(
                            packing->foams->pieces[piece], piece < static_cast<std::size_t>(item.layer),
                            packing->space, placed, zone.asked.keep_off_mm - 0.011))
                            << "piece " << piece;
                }
    }
    EXPECT_GT(looked_at, kits * 20);
    EXPECT_GT(trays, kits / 10);
    EXPECT_GT(layered, kits / 10);
}

TEST(Zones, CutTheColumnsThatTheirSurfaceReachesAndNoMore) {
    long long more = 0;
    for (int seed = 0; seed < test::fit_cases() / 2; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 92000);
        const test::RandomDesign soup = test::random_design(random);
        Object object;
        object.mesh = soup.mesh;
        object.measure = measure(soup.mesh);
        const Zones zones{test::random_zone(random, object)};
        auto placed = place_zones(object, zones, soup.placement);
        if (!placed) continue;  // it holds the whole soup
        Item item{};
        item.placement = soup.placement;
        item.cut = {soup.clearance, soup.cut_on_touch};
        item.zones = std::move(*placed);
        HalfCuts cuts = half_cuts(object_depths(soup.mesh, soup.placement, soup.space, item.cut), soup.space);
        const auto found = cut_zones(item, 0, soup.space, cuts);
        ASSERT_TRUE(found && found->size() == 1);
        const auto brute = [&](const Mesh& mesh, double clearance) {
            return test::brute_force_cut(test::placed_triangles(mesh, soup.placement), soup.space, clearance,
                                         soup.cut_on_touch);
        };
        const test::Blocks own = brute(soup.mesh, soup.clearance),
                           kept_off = brute(item.zones[0].surface->mesh, zones[0].keep_off_mm);
        long long blocks = 0;
        for (int j = 0; j < soup.space.blocks.y; ++j)
            for (int k = 0; k < soup.space.blocks.z; ++k) {
                int first = soup.space.blocks.x, end = 0, first_own = first, end_own = 0;
                for (int i = 0; i < soup.space.blocks.x; ++i) {
                    if (own.cut(i, j, k)) first_own = std::min(first_own, i), end_own = i + 1;
                    if (own.cut(i, j, k) || kept_off.cut(i, j, k)) first = std::min(first, i), end = i + 1;
                }
                blocks += std::max(0, end - first) - std::max(0, end_own - first_own);
                const CutRun run = cuts.lower(j, k);
                ASSERT_EQ(run.none(), first >= end) << j << " " << k;
                if (run.none()) continue;
                ASSERT_EQ(run.first, first) << j << " " << k;
                ASSERT_EQ(run.end, end) << j << " " << k;
            }
        ASSERT_EQ(found->front().blocks, blocks);
        more += blocks;
    }
    EXPECT_GT(more, 0);
}

TEST(Zones, SurfaceIsWhatLiesInTheBallsAndALittleMore) {
    const Object object = prepare(*sample("camera"), Design()).value();
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed + 5);
        const Zone zone = test::random_zone(random, object);
        const auto part = zone_surface(object, zone);
        ASSERT_TRUE(part);
        for (const Vec3f& vertex : part->mesh.vertices) {
            Zone larger = zone;  // a piece of 1 mm or of a small triangle reaches so far out
            for (Zone::Ball& ball : larger.balls) ball.radius_mm += 1.001;
            ASSERT_TRUE(test::is_in(larger, vec_cast<double>(vertex) + object.mesh.origin));
        }
        double area = 0;
        for (const Triangle& t : part->mesh.triangles) {
            const auto corner = [&](std::size_t i) { return vec_cast<double>(part->mesh.vertices[t[i]]); };
            area += length(cross(corner(1) - corner(0), corner(2) - corner(0))) / 2;
        }
        EXPECT_GT(area, 0);
    }
}

TEST(Zones, OfAPartAreThePart) {
    Mesh two = test::box_mesh({0, 0, 0}, {10, 10, 10});
    const Mesh other = test::box_mesh({30, 0, 0}, {34, 4, 4});
    test::append(two, other);
    Design design;
    design.object.units = Unit::mm;
    const Object object = prepare(two, design).value();
    Zone zone;
    zone.part = 2;
    zone.keep_off_mm = 5;
    const auto part = zone_surface(object, zone);
    ASSERT_TRUE(part);
    EXPECT_EQ(part->mesh.triangles.size(), other.triangles.size());
    zone.part = 3;
    EXPECT_FALSE(zone_surface(object, zone));
}

TEST(Zones, OfAClearanceThatIsWiderChangeNothing) {
    Design design = test::box_design(12);
    const Mesh mesh = test::box_mesh({0, 0, 0}, {40, 40, 40});
    const Packing without = test::packed(mesh, design);
    Zone zone;
    zone.balls = {{{40, 40, 40}, 8}};
    zone.keep_off_mm = 11;
    design.protection.zones = {zone};
    const Packing with = test::packed(mesh, design);
    EXPECT_EQ(with.layers, without.layers);
    ASSERT_EQ(with.zone_cuts.size(), 1U);
    EXPECT_EQ(with.zone_cuts.front().blocks, 0);
}

}  // namespace
}  // namespace snug
