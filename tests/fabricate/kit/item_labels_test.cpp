#include "snug/fabricate/kit/item_labels.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "snug/drawing/stroke_text.h"
#include "snug/make.h"

#include "tests/support/cases.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

using test::Random;

struct LabelledTray {
    Packing packing;
    ItemLabels labels;
};

LabelledTray labelled_tray(Random& random) {
    Design design;
    design.object.units = Unit::mm;
    design.space.blocks.reset();
    design.space.block_mm = {random.between(3, 15), random.between(2, 15), random.between(2, 15)};
    design.space.open = random.between(0.2, 1);
    std::vector<Object> objects;
    std::vector<std::string> names;
    design.items.clear();
    for (int i = random.integer(1, 6); i > 0; --i) {
        const Vec3d size{random.between(10, 60), random.between(10, 90), random.between(10, 90)};
        objects.push_back(prepare(test::box_mesh(size * -0.5, size * 0.5), design).value());
        ItemOptions item;
        item.object = static_cast<int>(objects.size()) - 1;
        design.items.push_back(item);
        names.push_back(random.chance(0.2) ? "花瓶" : random.chance(0.5) ? "vase" : "a box of tools 12/4");
    }
    LabelledTray tray{pack(objects, checked(design).value()).value(), {}};
    tray.labels =
        item_labels(tray.packing.items, names, tray.packing.layers, *tray.packing.foams, tray.packing.space);
    return tray;
}

struct Extent2 {
    double low_z = 1e9, high_z = -1e9, low_y = 1e9, high_y = -1e9;
};

Extent2 extent_of(const ItemLabel& label) {
    Extent2 box;
    for (const auto& line : stroke_text(label.strokes, {}, label.height_mm))
        for (const Vec2d p : line) {
            box.low_z = std::min(box.low_z, p.x);
            box.high_z = std::max(box.high_z, p.x);
            box.low_y = std::min(box.low_y, p.y);
            box.high_y = std::max(box.high_y, p.y);
        }
    const double z = label.middle.x - (box.low_z + box.high_z) / 2,
                 y = label.middle.y - (box.low_y + box.high_y) / 2;
    return {box.low_z + z, box.high_z + z, box.low_y + y, box.high_y + y};
}

TEST(ItemLabels, StandOnFlatFoamBesideTheirItemsAndOnNoOther) {
    int labels = 0, strange = 0;
    for (int seed = 0; seed < test::cases(200, 40); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 61000);
        const auto [packing, made] = labelled_tray(random);
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
