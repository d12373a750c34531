#include "snug/search/other_arrangements.h"

#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>

#include "snug/search/fill_space.h"

#include "tests/support/cases.h"
#include "tests/support/kit_to_arrange.h"
#include "tests/support/shapes.h"

// Arrangements to choose from, and as many copies as go in: each as the method then packs it.

namespace snug {
namespace {

using test::KitToArrange;
using test::Random;
using test::sample_kit;

void expect_packs(KitToArrange& kit, const Design& arranged, double volume_mm3) {
    const Packing packing = pack(kit.objects, arranged).value();
    ASSERT_TRUE(packing.foams) << text(packing.findings.front().message);
    for (const Finding& finding : packing.findings) EXPECT_NE(finding.code(), "items_near");
    KitToArrange as_arranged{arranged, kit.objects};
    test::expect_room_between(packing, as_arranged);
    const double volume = static_cast<double>(packing.space.block_count()) * packing.space.block_volume();
    EXPECT_NEAR(volume_mm3, volume, 1e-6 * volume);
}

TEST(OtherArrangements, PackAndDiffer) {
    int narrower = 0, in_other_layers = 0;
    for (int seed = 0; seed < test::cases(25, 6); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 4700);
        KitToArrange kit = test::random_kit_to_arrange(random);
        Design best = kit.design;
        const auto found = arrange(kit.objects, best, true, 1'500'000);
        if (!found) continue;
        double before = 0;
        for (const ArrangedDesign& other : other_arrangements(kit.objects, kit.design, best, 3'000'000)) {
            expect_packs(kit, other.design, other.arrangement.volume_mm3);
            test::expect_walls(pack(kit.objects, other.design).value(), kit.design);
            EXPECT_GE(other.arrangement.volume_mm3, before);
            before = other.arrangement.volume_mm3;
            in_other_layers += layers_of(other.design) != layers_of(best);
            if (!best.space.blocks) continue;
            EXPECT_NE(*other.design.space.blocks, *best.space.blocks);
            narrower += other.design.space.blocks->y < best.space.blocks->y;
        }
    }
    EXPECT_GT(narrower, 0);
    EXPECT_GT(in_other_layers, 0);
}

TEST(FillSpace, PutsInCopiesThatPack) {
    int more = 0;
    const int kits = test::cases(20, 5);
    for (int seed = 0; seed < kits; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 4800);
        KitToArrange kit = test::random_kit_to_arrange(random);
        Design& design = kit.design;
        if (!design.case_options.inside_mm)
            design.space.blocks =
                Vec3i{random.integer(14, 18), random.integer(14, 22), random.integer(14, 22)};
        const auto last = static_cast<int>(design.items.size()) - 1;
        const auto item = static_cast<std::size_t>(random.integer(0, last));
        const std::size_t before = design.items.size();
        std::size_t told = 0;
        const ArrangeWatch watch{{}, [&](const Design& better) {
                                     EXPECT_GT(better.items.size(), told);
                                     told = better.items.size();
                                 }};
        Design filled = design;
        const auto found = fill_space(kit.objects, filled, item, 1'000'000, watch);
        if (!found) {
            EXPECT_EQ(found.error().kind, ErrorKind::does_not_fit) << text(found.error().message);
            EXPECT_EQ(filled, design);
            continue;
        }
        EXPECT_EQ(filled.items.size(), told);
        for (std::size_t i = before; i < filled.items.size(); ++i)
            EXPECT_EQ(filled.items[i].object, design.items[item].object);
        expect_packs(kit, filled, found->volume_mm3);
        more += filled.items.size() > before;
    }
    EXPECT_GT(more, kits / 4);
}

/// Boxes of whole blocks: how many go in beside each other anybody can count.
TEST(FillSpace, PutsInAsManyBoxesAsThereIsRoomFor) {
    KitToArrange kit;
    Design& design = kit.design;
    design.object.units = Unit::mm;
    design.space.block_mm = {10, 10, 10};
    design.cut.clearance_mm = Clearance{};
    design.space.between_mm = 10;
    design.space.wall_mm = equal_walls(10);
    kit.objects.push_back(prepare(test::box_mesh({-15, -20, -25}, {15, 20, 25}), design).value());
    for (const auto& [rows, columns] : {std::pair(1, 1), std::pair(2, 3), std::pair(4, 2)}) {
        design.space.blocks = Vec3i{5, 2 + 5 * rows - 1, 2 + 6 * columns - 1};
        Design filled = design;
        const auto found = fill_space(kit.objects, filled, 0, 20'000'000);
        ASSERT_TRUE(found) << text(found.error().message);
        EXPECT_EQ(filled.items.size(), static_cast<std::size_t>(rows * columns));
    }
}

TEST(FillSpace, SaysWhatItNeeds) {
    KitToArrange kit = sample_kit(2);
    Design design = kit.design;
    EXPECT_EQ(fill_space(kit.objects, design, 0, 1'000'000).error().message.code, "arrange.fills_nothing");
    EXPECT_EQ(design, kit.design);
    EXPECT_EQ(fill_space(kit.objects, design, 2, 1'000'000).error().message.code, "arrange.no_item");
    design.space.blocks = kit.design.space.blocks = Vec3i{3, 3, 3};
    EXPECT_EQ(fill_space(kit.objects, design, 0, 1'000'000).error().kind, ErrorKind::does_not_fit);
    EXPECT_EQ(design, kit.design);
}

}  // namespace
}  // namespace snug
