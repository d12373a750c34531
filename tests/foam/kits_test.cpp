#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "snug/make.h"
#include "snug/space/available.h"

#include "tests/support/broken_foams.h"
#include "tests/support/brute_force.h"
#include "tests/support/cases.h"
#include "tests/support/fit_designs.h"
#include "tests/support/random.h"
#include "tests/support/random_design.h"

// Several items in one case, against a brute force that unites clipped items.

namespace snug {
namespace {

using test::Blocks;
using test::Random;

struct Kit {
    Design design;
    std::vector<Object> objects;
};

/// Two to eight items of up to four random soups, some with choices of their own, in a fitted space, a chosen
/// one or a case.
Kit random_kit(Random& random) {
    Kit kit;
    Design& design = kit.design;
    design.object.units = Unit::mm;
    design.space.block_mm = {random.between(3, 20), random.between(8, 25), random.between(8, 25)};
    design.space.blocks.reset();
    design.cut.clearance_mm = test::random_clearance(random, design.space.block_mm);
    design.cut.cut_on_touch = random.chance(0.3);
    if (random.chance(0.5)) design.placement.rotation_deg = {random.between(-180, 180), 90, 0};
    if (random.chance(0.3)) design.space.between_mm = random.between(0, 60);
    if (random.chance(0.3)) design.fit.least_rib_mm = random.between(1, 40);
    if (random.chance(0.3)) design.fit.notches = NotchOptions{40, 25, 10, {}, {}, {}};
    if (random.chance(0.2)) design.space.wall_mm = Walls{20, 30, 5, 60, 0, 44};
    const int objects = random.integer(1, 4);
    for (int i = 0; i < objects; ++i) {
        const Vec3d size{random.between(20, 80), random.between(20, 90), random.between(20, 90)};
        kit.objects.push_back(
            prepare(test::random_soup(random, size, random.integer(2, 12)), design).value());
        kit.objects.back().name = std::string(1, static_cast<char>('a' + i));
    }
    const bool row = random.chance(0.5);
    design.items.clear();
    for (int i = random.integer(std::max(2, objects), 8); i > 0; --i) {
        ItemOptions item;
        item.object = random.integer(0, objects - 1);
        if (!row)
            item.offset_mm =
                Vec3d{random.between(-30, 30), random.between(-150, 150), random.between(-150, 150)};
        if (random.chance(0.4))
            item.rotation_deg = Vec3d{90.0 * random.integer(0, 3), random.between(-90, 90), 0};
        if (random.chance(0.4)) item.clearance_mm = test::random_clearance(random, design.space.block_mm);
        if (random.chance(0.3)) item.group = random.chance(0.5) ? "one" : "two";
        design.items.push_back(item);
    }
    if (!row && random.chance(0.4)) {
        design.case_options.inside_mm = Vec3d{300, 700, 725};
        design.case_options.lid_mm = random.between(40, 150);
        design.case_options.corner_radius_mm = random.between(0, 60);
        design.case_options.base_mm = CrossSection{random.between(600, 700), random.between(600, 725)};
    }
    return kit;
}

void include(Blocks& all, const Blocks& more, Vec3i n) {
    for (int i = 0; i < n.x; ++i)
        for (int j = 0; j < n.y; ++j)
            for (int k = 0; k < n.z; ++k)
                if (more.cut(i, j, k)) all.set_cut(i, j, k);
}

using Columns = std::set<std::pair<int, int>>;

Columns columns_of(const Blocks& cut, Vec3i n) {
    Columns columns;
    for (int i = 0; i < n.x; ++i)
        for (int j = 0; j < n.y; ++j)
            for (int k = 0; k < n.z; ++k)
                if (cut.cut(i, j, k)) columns.insert({j, k});
    return columns;
}

double distance(const Columns& a, const Columns& b, Vec3d block) {
    const auto apart = [](int i, int j, double size) { return std::max(0, std::abs(i - j) - 1) * size; };
    double least = 1e9;
    for (const auto& [j, k] : a)
        for (const auto& [l, m] : b)
            least = std::min(least, std::max(apart(j, l, block.y), apart(k, m, block.z)));
    return least;
}

bool said_to_be_near(const Packing& packing, const std::string& one, const std::string& other) {
    return std::any_of(packing.findings.begin(), packing.findings.end(), [&](const Finding& finding) {
        const std::string said = text(finding.message);
        return finding.code() == "items_near" &&
               (said.find("between " + one + " and " + other + " stand") == 0 ||
                said.find(one + " and " + other + " lie in") == 0);
    });
}

TEST(Kits, EveryItemHasItsRoomComesOutAndStandsFarEnoughFromOthers) {
    int packed = 0, near = 0, far = 0, rows = 0, in_cases = 0;
    const int kits = test::cases(166, 30);
    for (int seed = 0; seed < kits; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 77000);
        Kit kit = random_kit(random);
        for (std::size_t i = 0; i < kit.design.items.size(); ++i)
            kit.design.items[i].name = "item" + std::to_string(i) + "!";
        const auto design = checked(kit.design);
        ASSERT_TRUE(design) << text(design.error().message);
        const auto packing = pack(kit.objects, *design);
        if (!packing || !packing->foams) continue;
        ++packed;
        const Vec3i n = packing->space.blocks;
        Blocks below(n), above(n);
        std::vector<Columns> columns;
        for (const Item& item : packing->items) {
            const auto triangles = test::placed_triangles(kit.objects[item.object].mesh, item.placement);
            const auto cut = [&](Vec3d own) {
                return test::brute_force_cut(triangles, packing->space, own, design->cut.cut_on_touch);
            };
            Blocks own = cut(item.cut.clearance_mm.lower);
            const Blocks upper = cut(item.cut.clearance_mm.upper);
            include(below, own, n);
            include(above, upper, n);
            include(own, upper, n);
            columns.push_back(columns_of(own, n));
        }
        const test::Broken broken = test::broken_by(*packing, below, above);
        ASSERT_EQ(broken.in_room, 0);
        ASSERT_EQ(broken.in_the_way, 0);

        const double wanted = wanted_between_mm(design->space);
        for (std::size_t a = 0; a < columns.size(); ++a)
            for (std::size_t b = a + 1; b < columns.size(); ++b) {
                const Item &one = packing->items[a], &other = packing->items[b];
                const bool together = !one.group.empty() && one.group == other.group;
                const bool too_near =
                    !together && distance(columns[a], columns[b], packing->space.block_mm) < wanted - 1e-6;
                ASSERT_EQ(said_to_be_near(*packing, one.name, other.name), too_near) << a << " " << b;
                near += too_near;
                far += !too_near && !together;
            }
        const bool row = !design->items.front().offset_mm;
        if (row) {
            EXPECT_FALSE(said_to_be_near(*packing, packing->items[0].name, packing->items[1].name));
        }
        rows += row;
        in_cases += !fills_box(packing->available, n.x);
    }
    EXPECT_GT(packed, kits / 3);
    EXPECT_GT(near, kits / 6);
    EXPECT_GT(far, kits / 2);
    EXPECT_GT(rows, kits / 6);
    EXPECT_GT(in_cases, 0);
}

TEST(Kits, ARowCutsWhatTheSameItemsCutWherePutByHand) {
    Random random(5);
    Design design;
    design.object.units = Unit::mm;
    design.space.blocks.reset();
    std::vector<Object> objects;
    for (const char* name : {"small", "large"}) {
        const double size = objects.empty() ? 30 : 90;
        objects.push_back(prepare(test::random_soup(random, {size, size, size}, 9), design).value());
        objects.back().name = name;
    }
    design.items = {{}, {}, {}};
    design.items[2].object = 1;
    const Packing row = pack(objects, design).value();
    ASSERT_TRUE(row.foams);
    EXPECT_EQ(row.items[0].offset_mm.z > row.items[2].offset_mm.z, true) << "the largest stands first";
    Design placed = design;
    placed.space.blocks = row.space.blocks;
    for (std::size_t i = 0; i < 3; ++i) placed.items[i].offset_mm = row.items[i].offset_mm;
    const Packing again = pack(objects, placed).value();
    EXPECT_TRUE(std::equal(row.blocks.begin(), row.blocks.end(), again.blocks.begin(), again.blocks.end()));
}

TEST(Kits, AnItemOutsideIsNamedAndNothingIsMade) {
    Random random(8);
    Design design;
    design.object.units = Unit::mm;
    std::vector<Object> objects{prepare(test::random_soup(random, {50, 50, 50}, 9), design).value()};
    design.items = {{}, {}};
    design.items[0].offset_mm = Vec3d{};
    design.items[1].offset_mm = Vec3d{0, 0, 500};
    design.items[1].name = "spare lens";
    const Packing packing = pack(objects, design).value();
    EXPECT_FALSE(packing.foams);
    ASSERT_EQ(packing.findings.size(), 1u);
    EXPECT_EQ(packing.findings.front().code(), "outside");
    EXPECT_EQ(packing.findings.front().of, "spare lens");
    design.items[1].object = 7;
    ASSERT_FALSE(pack(objects, design));
    EXPECT_EQ(pack(objects, design).error().kind, ErrorKind::usage);
}

}  // namespace
}  // namespace snug
