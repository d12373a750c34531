#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/space/available.h"

#include "tests/support/broken_foams.h"
#include "tests/support/brute_force.h"
#include "tests/support/cut_columns.h"
#include "tests/support/fit_designs.h"
#include "tests/support/random.h"
#include "tests/support/random_design.h"

namespace snug::test {

struct KitToArrange {
    Design design;
    std::vector<Object> objects;
};

/// Two to five items of up to three random soups that have no places yet, in a fitted space or a case, in one
/// layer or several.
inline KitToArrange random_kit_to_arrange(Random& random) {
    KitToArrange kit;
    Design& design = kit.design;
    design.object.units = Unit::mm;
    design.space.block_mm = {random.between(8, 25), random.between(10, 25), random.between(10, 25)};
    design.space.blocks.reset();
    design.cut.clearance_mm = random_clearance(random, design.space.block_mm);
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
        kit.objects.push_back(prepare(random_soup(random, size, random.integer(3, 12)), design).value());
        kit.objects.back().name = std::string(1, static_cast<char>('a' + i));
    }
    design.items.clear();
    for (int i = random.integer(2, 5); i > 0; --i) {
        ItemOptions item;
        item.object = random.integer(0, count - 1);
        if (random.chance(0.3)) item.group = "one";
        if (random.chance(0.3)) item.rotation_deg = Vec3d{random.between(-180, 180), 90, 0};
        if (random.chance(0.3)) item.clearance_mm = random_clearance(random, design.space.block_mm);
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

/// What each item and its zones cut of the foam below and above it, by the brute force, keeps what is wanted.
inline void expect_room_between(const Packing& packing, const KitToArrange& kit) {
    std::vector<std::pair<Columns, Columns>> ends;
    for (const Item& item : packing.items) {
        const auto add = [&](const Mesh& mesh, Vec3d clearance, Columns& columns) {
            const Blocks cut =
                brute_force_cut(placed_triangles(mesh, item.placement), packing.space, clearance, false);
            for (const auto& [at, run] : columns_of(cut, packing.space.blocks)) {
                Run& all = columns.try_emplace(at, run).first->second;
                all = {std::min(all.first, run.first), std::max(all.end, run.end)};
            }
        };
        const auto cut = [&](Vec3d clearance) {
            Columns columns;
            add(kit.objects[item.object].mesh, clearance, columns);
            for (const ItemZone& zone : item.zones) {
                const double mm = zone.asked.keep_off_mm;
                if (mm > 0) add(zone.surface->mesh, {mm, mm, mm}, columns);
            }
            return columns;
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
                EXPECT_GE(distance(ends[a].first, ends[b].first, block, true), wanted - 1e-6);
                EXPECT_GE(distance(ends[a].second, ends[b].first, block, true), wanted - 1e-6);
                EXPECT_GE(distance(ends[a].first, ends[b].second, block, true), wanted - 1e-6);
            } else {
                const std::size_t low = one.layer > other.layer ? b : a, high = a + b - low;
                EXPECT_GE(distance(ends[low].second, ends[high].first, block, false), wanted - 1e-6);
            }
        }
}

inline void expect_walls(const Packing& packing, const Design& design) {
    const Walls wanted = wanted_wall_mm(design.space);
    for (std::size_t side = 0; side < 6; ++side)
        if (!packing.foams->open() || side > 1) {
            EXPECT_GE(packing.fit.wall_mm[side], wanted[side] - 1e-6) << side;
        }
}

/// Of the samples, one after the other.
inline KitToArrange sample_kit(int items) {
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

}  // namespace snug::test
