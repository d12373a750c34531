#include "snug/fabricate/kit/item_labels.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/cases.h"
#include "tests/support/labelled_tray.h"

namespace snug {
namespace {

using test::Random;

struct Extent2 {
    double low_z = 1e9, high_z = -1e9, low_y = 1e9, high_y = -1e9;
};

Extent2 extent_of(const ItemLabel& label) {
    Extent2 box;
    for (const auto& line : label_lines(label))
        for (const Vec2d p : line) {
            box.low_z = std::min(box.low_z, p.x);
            box.high_z = std::max(box.high_z, p.x);
            box.low_y = std::min(box.low_y, p.y);
            box.high_y = std::max(box.high_y, p.y);
        }
    return box;
}

TEST(ItemLabels, StandOnFlatFoamBesideTheirItemsAndOnNoOther) {
    int labels = 0, strange = 0;
    for (int seed = 0; seed < test::cases(200, 40); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 61000);
        const double away = seed % 2 == 0 ? 0 : 3 + seed % 13;
        const auto [packing, made] = test::labelled_tray(random, false, away);
        const DesignSpace& space = packing.space;
        std::size_t without = 0;
        for (const Finding& finding : made.findings) {
            without += finding.code() == "no_label";
            strange += finding.code() == "label_letters";
        }
        ASSERT_EQ(made.labels.size() + without, packing.items.size());
        std::vector<Extent2> boxes;
        for (const ItemLabel& label : made.labels) {
            const Extent2 box = extent_of(label);
            for (int j = 0; j < space.blocks.y; ++j)
                for (int k = 0; k < space.blocks.z; ++k) {
                    const bool met =
                        box.high_y > j * space.block_mm.y && box.low_y < (j + 1) * space.block_mm.y &&
                        box.high_z > k * space.block_mm.z && box.low_z < (k + 1) * space.block_mm.z;
                    const bool near = box.high_y + away > j * space.block_mm.y &&
                                      box.low_y - away < (j + 1) * space.block_mm.y &&
                                      box.high_z + away > k * space.block_mm.z &&
                                      box.low_z - away < (k + 1) * space.block_mm.z;
                    if (near) {
                        ASSERT_TRUE(packing.layers.back()(j, k).none());
                    }
                    if (met) {
                        ASSERT_EQ(packing.foams->pieces.back()(j, k).end, packing.foams->parting.back());
                    }
                }
            for (const Extent2& other : boxes)
                ASSERT_TRUE(box.high_y < other.low_y || other.high_y < box.low_y ||
                            box.high_z < other.low_z || other.high_z < box.low_z);
            boxes.push_back(box);
            ++labels;
        }
    }
    EXPECT_GT(labels, 50);
    EXPECT_GT(strange, 5);
}

}  // namespace
}  // namespace snug
