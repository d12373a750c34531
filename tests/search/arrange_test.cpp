#include "snug/search/arrange.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <tbb/global_control.h>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "snug/design/project.h"
#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/space/available.h"

#include "tests/support/broken_foams.h"
#include "tests/support/brute_force.h"
#include "tests/support/cases.h"
#include "tests/support/cut_columns.h"
#include "tests/support/fit_designs.h"
#include "tests/support/random.h"
#include "tests/support/random_design.h"

// Arranged kits, as the method then packs them: against a brute force that clips every triangle.

namespace snug {
namespace {

using test::Columns;
using test::Random;

struct KitToArrange {
    Design design;
    std::vector<Object> objects;
};

/// Two to five items of up to three random soups that have no places yet, in a fitted space or a case, in one
/// layer or several.
KitToArrange random_kit_to_arrange(Random& random) {
    KitToArrange kit;
    Design& design = kit.design;
    design.object.units = Unit::mm;
    design.space.block_mm = {random.between(8, 25), random.between(10, 25), random.between(10, 25)};
    design.space.blocks.reset();
    design.cut.clearance_mm = test::random_clearance(random, design.space.block_mm);
    design.space.between_mm = random.chance(0.2) ? 0 : random.between(1, 40);
    design.space.wall_mm = Walls{random.between(0, 40), 30, random.between(0, 40), 10, 0, 25};
    design.search.seed = static_cast<std::uint32_t>(random.integer(0, 1000));
    const auto turns = random.integer(0, 9);
    design.search.turns = turns < 5   ? Turns::upright
                          : turns < 7 ? Turns::none
                          : turns < 9 ? Turns::quarter
                                      : Turns::any;
    const int count = random.integer(1, 3);
    for (int i = 0; i < count; ++i) {
        const Vec3d size{random.between(20, 60), random.between(20, 80), random.between(20, 80)};
        kit.objects.push_back(
            prepare(test::random_soup(random, size, random.integer(3, 12)), design).value());
        kit.objects.back().name = std::string(1, static_cast<char>('a' + i));
    }
    design.items.clear();
    for (int i = random.integer(2, 5); i > 0; --i) {
        ItemOptions item;
        item.object = random.integer(0, count - 1);
        if (random.chance(0.3)) item.group = "one";
        if (random.chance(0.3)) item.rotation_deg = Vec3d{random.between(-180, 180), 90, 0};
        if (random.chance(0.3)) item.clearance_mm = test::random_clearance(random, design.space.block_mm);
        design.items.push_back(item);
    }
    if (random.chance(0.3)) design.search.layers = random.integer(1, 2);
    if (random.chance(0.1)) design.search.layers.reset();
    if (random.chance(0.2)) design.space.open = random.between(0.3, 1);
    if (random.chance(0.3)) {
        design.case_options.inside_mm = Vec3d{300, 420, 425};
        // Higher than the wall, or halves that keep away differently would meet within it.
        design.case_options.lid_mm = random.between(90, 150);
        design.case_options.corner_radius_mm = random.between(0, 60);
        design.case_options.base_mm = CrossSection{random.between(380, 420), random.between(380, 425)};
    }
    return kit;
}

/// What each item cuts of the foam below and above it, by the brute force, keeps what is wanted.
void expect_room_between(const Packing& packing, const KitToArrange& kit) {
    std::vector<std::pair<Columns, Columns>> ends;
    for (const Item& item : packing.items) {
        const auto triangles = test::placed_triangles(kit.objects[item.object].mesh, item.placement);
        const auto cut = [&](Vec3d clearance) {
            return test::columns_of(test::brute_force_cut(triangles, packing.space, clearance, false),
                                    packing.space.blocks);
        };
        ends.push_back({cut(item.cut.clearance_mm.lower), cut(item.cut.clearance_mm.upper)});
    }
    const double wanted = wanted_between_mm(kit.design.space);
    const Vec3d block = packing.space.block_mm;
    for (std::size_t a = 0; a < ends.size(); ++a)
        for (std::size_t b = a + 1; b < ends.size(); ++b) {
            const Item &one = packing.items[a], &other = packing.items[b];
            if (!one.group.empty() && one.group == other.group) continue;
            if (one.layer == other.layer) {
                EXPECT_GE(test::distance(ends[a].first, ends[b].first, block, true), wanted - 1e-6);
                EXPECT_GE(test::distance(ends[a].second, ends[b].first, block, true), wanted - 1e-6);
                EXPECT_GE(test::distance(ends[a].first, ends[b].second, block, true), wanted - 1e-6);
            } else {
                const std::size_t low = one.layer > other.layer ? b : a, high = a + b - low;
                EXPECT_GE(test::distance(ends[low].second, ends[high].first, block, false), wanted - 1e-6);
            }
        }
}

void expect_walls(const Packing& packing, const Design& design) {
    const Walls wanted = wanted_wall_mm(design.space);
    for (std::size_t side = 0; side < 6; ++side)
        if (!packing.foams->open() || side > 1) {
            EXPECT_GE(packing.fit.wall_mm[side], wanted[side] - 1e-6) << side;
        }
}

/// Arranged once more in the space that it has now, around one item that stays.
bool stays_where_it_is_locked(KitToArrange& kit, const Design& arranged, std::size_t which) {
    Design again = arranged;
    again.items[which].lock = true;
    ++again.search.seed;
    const ItemOptions locked = again.items[which];
    if (!arrange(kit.objects, again, true, 1'000'000)) return false;
    EXPECT_EQ(again.items[which].offset_mm, locked.offset_mm);
    EXPECT_EQ(again.items[which].rotation_deg, locked.rotation_deg);
    const Packing packing = pack(kit.objects, again).value();
    EXPECT_TRUE(packing.foams);
    if (packing.foams) expect_room_between(packing, kit);
    return true;
}

TEST(Arrange, KeepsWallsAndWhatIsBetweenWhateverLiesThere) {
    int in_cases = 0, in_layers = 0, trays = 0, refused = 0, locked = 0;
    const int kits = test::cases(60, 12);
    for (int seed = 0; seed < kits; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 4400);
        KitToArrange kit = random_kit_to_arrange(random);
        const auto design = checked(kit.design);
        ASSERT_TRUE(design);
        Design arranged = *design;
        const auto found = arrange(kit.objects, arranged, true, 1'500'000);
        if (!found) {
            EXPECT_EQ(found.error().kind, ErrorKind::does_not_fit) << text(found.error().message);
            ++refused;
            continue;
        }
        const Packing packing = pack(kit.objects, arranged).value();
        ASSERT_TRUE(packing.foams) << text(packing.findings.front().message);
        for (const Finding& finding : packing.findings) EXPECT_NE(finding.code(), "items_near");
        expect_room_between(packing, kit);
        expect_walls(packing, *design);
        const double volume = static_cast<double>(packing.space.block_count()) * packing.space.block_volume();
        EXPECT_NEAR(found->volume_mm3, volume, 1e-6 * volume);
        EXPECT_LE(found->lower_bound_mm3.value_or(0), volume * (1 + 1e-9));
        // A project keeps it to the block.
        const Design kept = parse_design(design_json(arranged)).value();
        const Packing again = pack(kit.objects, kept).value();
        EXPECT_TRUE(std::equal(packing.layers.begin(), packing.layers.end(), again.layers.begin(),
                               again.layers.end()));
        if (seed % 3 == 0)
            locked += stays_where_it_is_locked(kit, arranged, static_cast<std::size_t>(random.integer(0, 1)));
        in_cases += packing.fitted_case.has_value();
        in_layers += packing.foams->layers() > 1;
        trays += packing.foams->open();
    }
    EXPECT_GT(in_cases, kits / 20);
    EXPECT_GT(in_layers, 0);
    EXPECT_GT(trays, 0);
    EXPECT_GT(locked, 0);
    EXPECT_LT(refused, kits / 4);
}

/// Of the samples, one after the other.
KitToArrange sample_kit(int items) {
    static const std::vector<Object> samples = [] {
        std::vector<Object> objects;
        for (const std::string_view name : {"camera", "torus", "vase"}) {
            Design design;
            design.object.units = Unit::mm;
            objects.push_back(prepare(sample(name).value(), design).value());
        }
        return objects;
    }();
    KitToArrange kit;
    kit.objects = samples;
    kit.design.object.units = Unit::mm;
    kit.design.space.blocks.reset();
    kit.design.items.assign(static_cast<std::size_t>(items), {});
    for (int i = 0; i < items; ++i) kit.design.items[static_cast<std::size_t>(i)].object = i % 3;
    return kit;
}

Design arranged_on(int threads, KitToArrange& kit) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    Design design = kit.design;
    EXPECT_TRUE(arrange(kit.objects, design, true, 8'000'000));
    return design;
}

TEST(Arrange, IsTheSameOnAnyNumberOfThreadsAndBetterThanARow) {
    KitToArrange kit = sample_kit(5);
    const Packing row = pack(kit.objects, kit.design).value();
    const Design arranged = arranged_on(1, kit);
    EXPECT_EQ(arranged, arranged_on(2, kit));
    const Packing packing = pack(kit.objects, arranged).value();
    EXPECT_LT(packing.space.block_count(), row.space.block_count() * 9 / 10);
}

TEST(Arrange, LeavesLockedItemsWhereTheyAre) {
    KitToArrange kit = sample_kit(3);
    kit.design.items[1].offset_mm = Vec3d{0, 31, -17};
    kit.design.items[1].lock = true;
    Design arranged = kit.design;
    ASSERT_TRUE(arrange(kit.objects, arranged, true, 4'000'000));
    EXPECT_EQ(arranged.items[1], kit.design.items[1]);
    const Packing packing = pack(kit.objects, arranged).value();
    ASSERT_TRUE(packing.foams);
    for (const Finding& finding : packing.findings) EXPECT_NE(finding.code(), "items_near");
    for (const double wall : packing.fit.wall_mm) EXPECT_GE(wall, 50);
}

Error refusal(KitToArrange& kit) {
    Design design = kit.design;
    const auto found = arrange(kit.objects, design, true, 2'000'000);
    EXPECT_FALSE(found);
    return found ? Error() : found.error();
}

TEST(Arrange, SaysWhatIsInTheWay) {
    KitToArrange kit = sample_kit(4);
    kit.design.items[0].lock = true;
    EXPECT_EQ(refusal(kit).message.code, "arrange.locked_nowhere");
    kit.design.items[0].offset_mm = Vec3d{};
    kit.design.items[1].lock = true;
    kit.design.items[1].offset_mm = Vec3d{0, 5, 0};
    EXPECT_EQ(refusal(kit).message.code, "arrange.locked_meet");
    kit.design.items[0].lock = kit.design.items[1].lock = false;
    kit.design.search.layers = 5;
    EXPECT_EQ(refusal(kit).message.code, "arrange.layers");
    kit.design.search.layers = 1;
    kit.design.space.blocks = Vec3i{16, 16, 10};
    const Error error = refusal(kit);
    EXPECT_EQ(error.kind, ErrorKind::does_not_fit);
    EXPECT_NE(text(error.message).find("blocks would hold all"), std::string::npos) << text(error.message);
}

}  // namespace
}  // namespace snug
