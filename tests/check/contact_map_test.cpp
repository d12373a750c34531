#include "snug/check/contact_map.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "snug/check/gravity.h"
#include "snug/check/protection.h"
#include "snug/design/known_foams.h"
#include "snug/formats/mesh_files.h"
#include "snug/make.h"
#include "snug/samples/samples.h"

#include "tests/support/cases.h"
#include "tests/support/fit_designs.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

/// Foam with data, and a drop.
Design dropped_design(const char* foam, double height_mm) {
    Design design = test::box_design();
    design.protection.foam = find_foam(built_in_foams(), foam).value();
    design.protection.height_mm = height_mm;
    return design;
}

struct Dropped {
    std::vector<Object> objects;
    Packing packing;
    Protection protection;

    [[nodiscard]] ContactMap map(std::optional<Side> side) const {
        auto found = contact_map(objects, packing, protection, side);
        EXPECT_TRUE(found);
        return std::move(*found);
    }
};

Dropped dropped(std::vector<Object> objects, const Design& design) {
    auto packing = pack(objects, design);
    EXPECT_TRUE(packing && packing->foams);
    Dropped all{std::move(objects), std::move(*packing), {}};
    auto found = protection(all.objects, all.packing, design);
    EXPECT_TRUE(found);
    all.protection = std::move(*found);
    return all;
}

Dropped dropped(const Mesh& mesh, const Design& design) {
    std::vector<Object> objects{prepare(mesh, design).value()};
    return dropped(std::move(objects), design);
}

/// What the columns push an item back with from the side that it is pressed into, less the others, N.
double newton_of(const ItemContacts& item, bool to_high) {
    double sum = 0;
    for (const PressedColumn& column : item.columns)
        sum += column.area_mm2 * column.kpa * (column.high == to_high ? 1e-3 : -1e-3);
    return sum;
}

double most_kpa_of(const ItemContacts& item, bool to_high) {
    double most = 0;
    for (const PressedColumn& column : item.columns)
        if (column.high == to_high) most = std::max(most, column.kpa);
    return most;
}

/// Of each item whose figures are known: the map's force is the report's, and so is its greatest pressure.
/// How many such items there were.
int expect_the_reports_forces(const Dropped& all) {
    int compared = 0;
    for (int side = 0; side < 6; ++side) {
        const ContactMap map = all.map(static_cast<Side>(side));
        EXPECT_EQ(map.axis, side / 2);
        for (std::size_t i = 0; i < map.items.size(); ++i) {
            SCOPED_TRACE("side " + std::to_string(side) + ", item " + std::to_string(i));
            const ItemProtection& item = all.protection.items[i];
            const FaceShock& face = item.faces[static_cast<std::size_t>(side)];
            EXPECT_EQ(map.items[i].why_none, face.why_none);
            EXPECT_EQ(map.items[i].columns.empty(), face.why_none != NoShock::none);
            if (!face.g_model) continue;
            ++compared;
            const double newton = *item.mass_kg * kStandardGravity * (*face.g_model + 1);
            // Joint drops read their forces from tables of 400 steps.
            EXPECT_NEAR(newton_of(map.items[i], side % 2 == 1) / newton, 1, 2e-3);
            EXPECT_NEAR(most_kpa_of(map.items[i], side % 2 == 1) / face.peak_kpa, 1, 1e-9);
        }
    }
    return compared;
}

TEST(ContactMap, OfABoxIsOnePressureUnderItsFace) {
    // 4 mm of gap below and above, 6 on the other sides; 40 mm of foam below.
    Design design = dropped_design("ld33", 500);
    design.workshop.mass_kg = 0.8;
    const Dropped all = dropped(test::box_mesh({-16, -34, -24}, {16, 34, 24}), design);
    EXPECT_GE(expect_the_reports_forces(all), 4);  // two of its ends are too small for this foam
    const ContactMap map = all.map(kFloor);
    const double squeezed = *all.protection.items.front().faces[kFloor].travel_mm - 4;
    const StressCurve curve(design.protection.foam->curve);
    double area = 0;
    for (const PressedColumn& column : map.items.front().columns) {
        EXPECT_FALSE(column.high);
        EXPECT_NEAR(column.strain, squeezed / 40, 1e-9);
        EXPECT_NEAR(column.kpa, curve.at(squeezed / 40).kpa, 1e-9);
        EXPECT_NEAR(column.from_mm, -60, 1e-9);
        EXPECT_NEAR(column.to_mm, -16, 1e-9);
        EXPECT_LE(std::fabs(column.u_mm), 34 + 1e-6);
        EXPECT_LE(std::fabs(column.v_mm), 24 + 1e-6);
        // Within the cell that it stands for.
        EXPECT_NEAR(-100 + (column.row + 0.5) * map.cell_mm.x, column.u_mm, map.cell_mm.x / 2);
        EXPECT_NEAR(-100 + (column.column + 0.5) * map.cell_mm.y, column.v_mm, map.cell_mm.y / 2);
        EXPECT_LT(column.row, map.rows);
        EXPECT_LT(column.column, map.columns);
        area += column.area_mm2;
    }
    EXPECT_NEAR(area / (68 * 48), 1, 1e-3);
}

TEST(ContactMap, OfASampleIsTheForceOfEachStopAndItsWeightAtRest) {
    for (const auto& [name, kg] : {std::pair{"camera", 0.9}, std::pair{"vase", 1.6}}) {
        SCOPED_TRACE(name);
        Design design = dropped_design("ld33", 400);
        design.workshop.mass_kg = kg;
        design.space.blocks.reset();
        design.space.wall_mm = equal_walls(80);
        const Dropped all = dropped(sample(name).value(), design);
        EXPECT_GE(expect_the_reports_forces(all), 4);
        const ItemContacts rest = all.map({}).items.front();
        ASSERT_EQ(rest.why_none, NoShock::none);
        EXPECT_NEAR(newton_of(rest, false) / (kg * kStandardGravity), 1, 1e-6);
        EXPECT_NEAR(most_kpa_of(rest, false), all.protection.items.front().rest.peak_kpa, 1e-9);
    }
}

TEST(ContactMap, OfItemsThatReachOneAnotherIsWhatEachMeets) {
    int compared = 0, between = 0;
    for (int n = 0; n < test::cases(4, 1); ++n) {
        test::Random random(static_cast<std::uint64_t>(40 + n));
        SCOPED_TRACE("seed " + std::to_string(40 + n));
        Design design = dropped_design("ethafoam-200lc", random.between(50, 200));
        design.space.blocks.reset();
        design.space.wall_mm = equal_walls(70);
        design.space.between_mm = random.between(30, 60);
        design.items.clear();
        std::vector<Object> objects;
        for (int i = 0; i < 2; ++i) {
            const Vec3d half{random.between(20, 40), random.between(20, 40), random.between(20, 40)};
            ItemOptions item;
            item.object = i;
            item.layer = i + 1;
            item.mass_kg = random.between(0.3, 1.2);
            design.items.push_back(item);
            objects.push_back(prepare(test::box_mesh(half * -1, half), design).value());
        }
        const Dropped all = dropped(std::move(objects), design);
        compared += expect_the_reports_forces(all);
        // At rest the upper item's weight goes through the lower one: so much more below than above.
        const ContactMap rest = all.map({});
        for (std::size_t i = 0; i < 2; ++i)
            EXPECT_NEAR(newton_of(rest.items[i], false) / (*design.items[i].mass_kg * kStandardGravity), 1,
                        2e-3);
        for (const PressedColumn& column : rest.items[0].columns) between += column.high;
    }
    EXPECT_GE(compared, 8 * test::cases(4, 1));
    // Some of them press on each other at rest.
    if (test::cases(4, 1) == 4) {
        EXPECT_GT(between, 0);
    }
}

TEST(ContactMap, IsEmptyUnderAPlaceThatFoamKeepsAwayFrom) {
    Design design = dropped_design("ld33", 300);
    design.workshop.mass_kg = 0.8;
    const Mesh box = test::box_mesh({-20, -40, -30}, {20, 40, 30});
    const Vec3d place{-20, 15, 5};
    const double reach = 12;
    const auto under_it = [&](const Dropped& all) {
        const auto columns = all.map(kFloor).items.front().columns;
        return std::count_if(columns.begin(), columns.end(), [&](const PressedColumn& column) {
            return std::hypot(column.u_mm - place.y, column.v_mm - place.z) < reach - 0.01;
        });
    };
    EXPECT_GT(under_it(dropped(box, design)), 0);
    Zone zone;
    zone.balls.push_back({place, reach});
    zone.keep_off_mm = 15;
    design.protection.zones.push_back(zone);
    const Dropped all = dropped(box, design);
    EXPECT_EQ(under_it(all), 0);
    EXPECT_GE(expect_the_reports_forces(all), 5);
}

TEST(ContactMap, IsOfNoneOfSeveralWhereTheMassOfOneIsNotKnown) {
    Design design = dropped_design("ld33", 300);
    design.space.blocks.reset();
    design.space.wall_mm = equal_walls(60);
    design.items.clear();
    std::vector<Object> objects;
    for (int i = 0; i < 2; ++i) {
        ItemOptions item;
        item.object = i;
        item.layer = i + 1;
        if (i == 0) item.mass_kg = 0.8;
        design.items.push_back(item);
        objects.push_back(prepare(test::box_mesh({-20, -40, -30}, {20, 40, 30}), design).value());
    }
    const ContactMap rest = dropped(std::move(objects), design).map({});
    for (const ItemContacts& item : rest.items) {
        EXPECT_EQ(item.why_none, NoShock::no_mass);
        EXPECT_TRUE(item.columns.empty());
    }
}

TEST(ContactMap, SaysWhyThereIsNone) {
    const Mesh box = test::box_mesh({-20, -40, -30}, {20, 40, 30});
    Design design = dropped_design("ld33", 500);
    EXPECT_EQ(dropped(box, design).map({}).items.front().why_none, NoShock::no_mass);
    EXPECT_EQ(dropped(box, design).map(kBack).items.front().why_none, NoShock::no_mass);
    design.workshop.mass_kg = 40;
    EXPECT_EQ(dropped(box, design).map(kFloor).items.front().why_none, NoShock::bottoms);
    design.workshop.mass_kg = 0.8;
    design.protection.height_mm.reset();
    const Dropped undropped = dropped(box, design);
    EXPECT_EQ(undropped.map(kFloor).items.front().why_none, NoShock::no_height);
    EXPECT_FALSE(undropped.map({}).items.front().columns.empty());
    design.protection.foam = find_foam(built_in_foams(), "ethafoam-220").value();
    EXPECT_EQ(dropped(box, design).map({}).items.front().why_none, NoShock::no_foam_data);
}

}  // namespace
}  // namespace snug
