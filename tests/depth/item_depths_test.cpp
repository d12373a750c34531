#include "snug/depth/item_depths.h"

#include <gtest/gtest.h>

#include "snug/make.h"
#include "snug/samples/samples.h"

// What is kept from one packing to the next.

namespace snug {
namespace {

class ItemDepths : public testing::Test {
  protected:
    ItemDepths() {
        for (const char* name : {"torus", "vase"})
            objects.push_back(prepare(sample(name).value(), {}).value());
        objects[0].edition = 7;
        objects[1].edition = 8;
        design.space.blocks = Vec3i{30, 30, 60};
        design.items = {ItemOptions(), ItemOptions()};
        for (int i = 0; i < 2; ++i) {
            design.items[static_cast<std::size_t>(i)].object = i;
            design.items[static_cast<std::size_t>(i)].offset_mm = Vec3d{0, 0, i * 300.0 - 150};
        }
    }

    /// Which items' depths are still those of the packing before.
    std::vector<bool> taken() {
        const std::vector<KeptDepths::Entry> before = kept.entries;
        const Packing packing = pack(objects, design, {}, &kept).value();
        const Packing fresh = pack(objects, design).value();
        EXPECT_EQ(packing.foams->pieces, fresh.foams->pieces);
        std::vector<bool> same;
        for (std::size_t i = 0; i < kept.entries.size(); ++i)
            same.push_back(i < before.size() && kept.entries[i].depths == before[i].depths);
        return same;
    }

    std::vector<Object> objects;
    Design design;
    KeptDepths kept;
};

TEST_F(ItemDepths, OfItemsThatStayAreTaken) {
    EXPECT_EQ(taken(), (std::vector<bool>{false, false}));
    EXPECT_EQ(taken(), (std::vector<bool>{true, true}));
    design.items[1].offset_mm->y += 1;
    EXPECT_EQ(taken(), (std::vector<bool>{true, false}));
    design.items[0].rotation_deg = Vec3d{0, 10, 0};
    EXPECT_EQ(taken(), (std::vector<bool>{false, true}));
    design.items[0].clearance_mm = Clearance{};
    design.items[0].clearance_mm->lower = Vec3d{1, 1, 1};
    EXPECT_EQ(taken(), (std::vector<bool>{false, true}));
}

TEST_F(ItemDepths, EndWithTheSpaceTheObjectOrAnotherClearanceOfAll) {
    (void)taken();
    objects[1].edition = 9;
    EXPECT_EQ(taken(), (std::vector<bool>{true, false}));
    design.space.blocks = Vec3i{32, 30, 60};
    EXPECT_EQ(taken(), (std::vector<bool>{false, false}));
    design.cut.cut_on_touch = true;
    EXPECT_EQ(taken(), (std::vector<bool>{false, false}));
}

TEST_F(ItemDepths, OfObjectsWithoutAnEditionAreNotKept) {
    objects[0].edition = 0;
    (void)taken();
    EXPECT_EQ(kept.entries.size(), 1u);
}

TEST_F(ItemDepths, OfTheSameObjectTwiceAreToldApart) {
    design.items[1].object = 0;
    (void)taken();
    std::swap(design.items[0].offset_mm, design.items[1].offset_mm);
    const std::vector<KeptDepths::Entry> before = kept.entries;
    (void)taken();
    EXPECT_EQ(kept.entries[0].depths, before[1].depths);
    EXPECT_EQ(kept.entries[1].depths, before[0].depths);
}

}  // namespace
}  // namespace snug
