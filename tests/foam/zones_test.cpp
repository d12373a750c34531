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

// Places on an item that foam keeps away from.

namespace snug {
namespace {

using test::point_of;
using test::Random;
using test::random_zone;

bool is_in(const Zone& zone, Vec3d p) {
    return std::any_of(zone.balls.begin(), zone.balls.end(), [&](const Zone::Ball& ball) {
        return dot(p - ball.centre, p - ball.centre) < ball.radius_mm * ball.radius_mm;
    });
}

/// Whether a block of the piece stands within `off` of a point along all axes, or where the point passes on
/// its way out of the piece: upwards from a piece below it, downwards from one above it.
bool stands_in_the_way(const Grid<Run>& piece, bool below, const DesignSpace& space, Vec3d p, double off) {
    for (int j = 0; j < piece.ny(); ++j)
        for (int k = 0; k < piece.nz(); ++k) {
            const Run kept = piece(j, k);
            if (kept.none()) continue;
            const bool beside = space.face(1, j) >= p.y + off || space.face(1, j + 1) <= p.y - off ||
                                space.face(2, k) >= p.z + off || space.face(2, k + 1) <= p.z - off;
            if (beside) continue;
            if (below ? space.face(0, kept.end) > p.x - off : space.face(0, kept.first) < p.x + off)
                return true;
        }
    return false;
}

struct ZonedKit {
    Design design;
    std::vector<Object> objects;
};

/// One to four random soups with zones, in a fitted space or a case, in layers or a tray.
ZonedKit random_kit_with_zones(Random& random) {
    ZonedKit kit;
    Design& design = kit.design;
    design.object.units = Unit::mm;
    design.space.block_mm = {random.between(3, 20), random.between(4, 25), random.between(4, 25)};
    design.space.blocks.reset();
    design.cut.clearance_mm = test::random_clearance(random, design.space.block_mm);
    design.cut.cut_on_touch = random.chance(0.3);
    if (random.chance(0.5)) design.placement.rotation_deg = {random.between(-180, 180), 90, 0};
    if (random.chance(0.3)) design.fit.least_rib_mm = random.between(1, 40);
    if (random.chance(0.3)) design.fit.notches = NotchOptions{40, 25, 10, {}, {}, {}};
    if (random.chance(0.3)) design.fit.lift = LiftOptions{random.between(10, 60), random.between(5, 25)};
    if (random.chance(0.3)) design.space.open = random.between(0.3, 1);
    const int items = random.integer(1, 4);
    design.items.clear();
    for (int i = 0; i < items; ++i) {
        const Vec3d size{random.between(20, 80), random.between(20, 90), random.between(20, 90)};
        kit.objects.push_back(
            prepare(test::random_soup(random, size, random.integer(3, 12)), design).value());
        ItemOptions item;
        item.object = i;
        item.layer = random.integer(1, std::min(i + 1, 2));
        if (random.chance(0.4)) item.rotation_deg = Vec3d{90, random.between(-90, 90), 0};
        for (int zone = random.integer(0, 2); zone > 0; --zone)
            item.zones.push_back(random_zone(random, kit.objects.back()));
        design.items.push_back(item);
    }
    return kit;
}

TEST(Zones, AreFreeAllRoundAndOnTheWayInAndOutOfEveryPiece) {
    int looked_at = 0, trays = 0, layered = 0;
    const int kits = test::cases(160, 30);
    for (int seed = 0; seed < kits; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 91000);
        const ZonedKit kit = random_kit_with_zones(random);
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
                    const Vec3d p = point_of(random, object.mesh);
                    if (!is_in(zone.asked, p + object.mesh.origin)) continue;
                    ++looked_at;
                    const Vec3d placed = item.placement(vec_cast<float>(p));
                    for (std::size_t piece = 0; piece < packing->foams->pieces.size(); ++piece)
                        ASSERT_FALSE(stands_in_the_way(
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
        const Zones zones{random_zone(random, object)};
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
        const Zone zone = random_zone(random, object);
        const auto part = zone_surface(object, zone);
        ASSERT_TRUE(part);
        for (const Vec3f& vertex : part->mesh.vertices) {
            Zone larger = zone;  // a piece of 1 mm or of a small triangle reaches so far out
            for (Zone::Ball& ball : larger.balls) ball.radius_mm += 1.001;
            ASSERT_TRUE(is_in(larger, vec_cast<double>(vertex) + object.mesh.origin));
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
