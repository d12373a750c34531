#pragma once

#include <string>
#include <utility>
#include <vector>

#include "snug/fabricate/kit/item_labels.h"
#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/make.h"

#include "tests/support/cut_foams.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace snug::test {

/// Boxes in a tray, with a label beside each that has room for it.
struct LabelledTray {
    Packing packing;
    ItemLabels labels;
    [[nodiscard]] FoamDesign foams() const {
        return {packing.space, packing.layers,    *packing.foams, packing.available,
                "tray",        Language::english, labels.labels};
    }
};

/// Of one layer or two; the labels keep so far away from all cavities.
[[nodiscard]] inline LabelledTray labelled_tray(Random& random, bool layers = false, double away_mm = 0) {
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
        objects.push_back(prepare(box_mesh(size * -0.5, size * 0.5), design).value());
        ItemOptions item;
        item.object = static_cast<int>(objects.size()) - 1;
        if (layers && i == 1) item.layer = 2;
        design.items.push_back(item);
        names.push_back(random.chance(0.2) ? "花瓶" : random.chance(0.5) ? "vase" : "a box of tools 12/4");
    }
    if (layers) design.items.front().layer = 1;
    LabelledTray tray{pack(objects, checked(design).value()).value(), {}};
    tray.labels = item_labels(tray.packing.items, names, tray.packing.layers, *tray.packing.foams,
                              tray.packing.space, away_mm);
    return tray;
}

/// A tray of one block of half a millimetre, with a pocket through it and a label beside that.
struct ThinTray {
    CutFoams foam;
    std::vector<ItemLabel> labels{{1, "1 THIN", "1 THIN", {60, 30}, 8, 0.5}};
    [[nodiscard]] FoamDesign foams() const {
        FoamDesign design = foam.design();
        design.labels = labels;
        return design;
    }
};

[[nodiscard]] inline ThinTray thin_tray() {
    BlockMap map(10, 20);
    for (int j = 2; j < 7; ++j)
        for (int k = 1; k < 6; ++k) map(j, k) = {0, 4};
    ThinTray tray{foams_of({{4, 10, 20}, {0.5, 5, 5}}, std::move(map), 1)};
    tray.foam.foams = without_lid(std::move(tray.foam.foams));
    return tray;
}

}  // namespace snug::test
