#include "snug/search/arrange.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <tbb/global_control.h>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "snug/design/project.h"

#include "tests/support/cases.h"
#include "tests/support/kit_to_arrange.h"

// Arranged kits, as the method then packs them: against a brute force that clips every triangle.

namespace snug {
namespace {

using test::expect_room_between;
using test::expect_walls;
using test::KitToArrange;
using test::Random;
using test::sample_kit;

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
        KitToArrange kit = test::random_kit_to_arrange(random);
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
