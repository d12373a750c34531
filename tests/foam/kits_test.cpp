#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "snug/make.h"
#include "snug/space/available.h"

#include "tests/support/broken_foams.h"
#include "tests/support/brute_force.h"
#include "tests/support/cases.h"
#include "tests/support/cut_columns.h"
#include "tests/support/fit_designs.h"
#include "tests/support/random.h"
#include "tests/support/random_design.h"
#include "tests/support/solid_checks.h"

// Several items in one case, against a brute force that unites clipped items.

namespace snug {
namespace {

using test::Blocks;
using test::Columns;
using test::columns_of;
using test::distance;
using test::Random;

struct Kit {
    Design design;
    std::vector<Object> objects;
};

/// Up to three, none of them empty.
void put_in_layers(Random& random, bool row, Design& design) {
    const int layers = std::min(random.integer(1, 3), static_cast<int>(design.items.size()));
    for (std::size_t i = 0; i < design.items.size(); ++i) {
        ItemOptions& item = design.items[i];
        item.layer = static_cast<int>(i) < layers ? static_cast<int>(i) + 1 : random.integer(1, layers);
        if (!row) item.offset_mm->x += 60 * (item.layer - 1) * random.integer(0, 2);
    }
}

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
    if (random.chance(0.3)) design.fit.lift = LiftOptions{random.between(10, 60), random.between(5, 25)};
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
    put_in_layers(random, row, design);
    if (random.chance(0.3))
        design.space.open = random.chance(0.7) ? random.between(0.1, 1) : random.between(2, 60);
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

bool said_to_be_near(const Packing& packing, const std::string& one, const std::string& other) {
    return std::any_of(packing.findings.begin(), packing.findings.end(), [&](const Finding& finding) {
        const std::string said = text(finding.message);
        return finding.code() == "items_near" &&
               (said.find("between " + one + " and " + other + " stand") == 0 ||
                said.find("between " + one + " and " + other + " in a layer above") == 0 ||
                said.find("between " + other + " and " + one + " in a layer above") == 0 ||
                said.find(one + " and " + other + " lie in") == 0);
    });
}

/// Kept, cut and missing blocks are all that there are, and solids hold what is kept.
void expect_nothing_lost(const Packing& packing) {
    const FitReport& fit = packing.fit;
    long long above = 0;  // a tray, where nothing is cut and nothing kept
    if (packing.foams->open())
        for (const Run there : packing.available)
            above += there.blocks() -
                     there.common({0, static_cast<std::int16_t>(packing.foams->parting.back())}).blocks();
    EXPECT_EQ(fit.foam_blocks() + fit.cut_blocks + fit.shortened_blocks + above, packing.space.block_count());
    for (const Piece piece : packing.foams->all())
        test::expect_solid_of(*packing.foams, piece, packing.space);
}

/// Whose foam ends at its surface, at the lowest block that an item cuts, or where no block exists; lower
/// only where hands reach in or ribs stood. `cut`: by the uppermost layer.
void expect_tray(const Packing& packing, const Design& design, const Blocks& cut) {
    const int level = packing.foams->parting.back();
    double surface = -1e9;
    for (const Item& item : packing.items) {
        if (item.layer != packing.foams->layers()) continue;
        const Box3d& box = item.placement.bounds;
        const double open = *design.space.open, height = box.max.x - box.min.x;
        surface = std::max(
            surface, box.min.x - item.offset_mm.x + (open <= 1 ? open * height : std::min(open, height)));
    }
    const double block = packing.space.block_mm.x, at = level * block - packing.space.blocks.x * block / 2;
    if (level > 1 && level < packing.space.blocks.x) {
        EXPECT_GE(at - surface, -1e-6 * block);
        EXPECT_LT(at - surface, block + 1e-6);
    }
    const Grid<Run>& kept = packing.foams->pieces.back();
    const bool exact = packing.notches.empty() && packing.rib_blocks == 0;
    for (int j = 0; j < kept.ny(); ++j)
        for (int k = 0; k < kept.nz(); ++k) {
            int end = 0;
            while (end < level && !cut.cut(end, j, k)) ++end;
            end = std::min<int>(end, packing.available(j, k).end);
            if (kept(j, k).none()) continue;
            ASSERT_LE(kept(j, k).end, end);
            if (exact) {
                ASSERT_EQ(kept(j, k).end, end);
            }
        }
}

/// However many notches there are, each item of an only layer keeps the foam below it. `cut`: by the layer.
void expect_support(const Packing& packing, const Blocks& cut) {
    const int level = packing.foams->parting.front();
    const Grid<Run>& kept = packing.foams->pieces.front();
    for (int j = 0; j < kept.ny(); ++j)
        for (int k = 0; k < kept.nz(); ++k) {
            int first = 0;
            while (first < level && !cut.cut(first, j, k)) ++first;
            if (first == level || first <= packing.available(j, k).first) continue;
            ASSERT_EQ(kept(j, k).end, std::min<int>(first, packing.available(j, k).end)) << j << " " << k;
        }
}

TEST(Kits, EveryItemHasItsRoomComesOutAndStandsFarEnoughFromOthers) {
    int packed = 0, near = 0, far = 0, rows = 0, in_cases = 0, in_layers = 0, trays = 0, notched = 0;
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
        const auto layers = static_cast<std::size_t>(packing->foams->layers());
        in_layers += layers > 1;
        std::vector<Blocks> below(layers, Blocks(n)), above(layers, Blocks(n));
        std::vector<Columns> columns;
        std::vector<std::pair<Columns, Columns>> ends;  // what each cuts of the foam below it and above it
        for (const Item& item : packing->items) {
            const auto triangles = test::placed_triangles(kit.objects[item.object].mesh, item.placement);
            const auto cut = [&](Vec3d own) {
                return test::brute_force_cut(triangles, packing->space, own, design->cut.cut_on_touch);
            };
            Blocks own = cut(item.cut.clearance_mm.lower);
            // Above the uppermost layer of a tray there is no foam to give way.
            const bool uncovered = packing->foams->open() && item.layer == static_cast<int>(layers);
            const Blocks upper = uncovered ? own : cut(item.cut.clearance_mm.upper);
            include(below[static_cast<std::size_t>(item.layer) - 1], own, n);
            include(above[static_cast<std::size_t>(item.layer) - 1], upper, n);
            ends.push_back({columns_of(own, n), columns_of(upper, n)});
            include(own, upper, n);
            columns.push_back(columns_of(own, n));
        }
        const test::Broken broken = test::broken_by(*packing, below, above);
        ASSERT_EQ(broken.in_room, 0);
        ASSERT_EQ(broken.in_the_way, 0);
        expect_nothing_lost(*packing);
        trays += packing->foams->open();
        if (!packing->notches.empty() && layers == 1 && packing->rib_blocks == 0) {
            expect_support(*packing, below.front());
            ++notched;
        }
        if (packing->foams->open()) expect_tray(*packing, *design, below.back());

        const double wanted = wanted_between_mm(design->space);
        for (std::size_t a = 0; a < columns.size(); ++a)
            for (std::size_t b = a + 1; b < columns.size(); ++b) {
                const Item &one = packing->items[a], &other = packing->items[b];
                const bool together = !one.group.empty() && one.group == other.group;
                const std::size_t low = one.layer > other.layer ? b : a, high = a + b - low;
                const Vec3d block = packing->space.block_mm;
                const double mm = one.layer == other.layer
                                      ? distance(columns[a], columns[b], block, true)
                                      : distance(ends[low].second, ends[high].first, block, false);
                const bool too_near = !together && mm < wanted - 1e-6;
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
    EXPECT_GT(in_layers, kits / 4);
    EXPECT_GT(trays, kits / 10);
    EXPECT_GT(notched, 0);
}

/// By the brute force: the columns of a slot, by what it says of itself.
bool in_slot(const LiftSlot& slot, const DesignSpace& space, int j, int k) {
    const bool along_z = slot.side == kBack || slot.side == kFront;
    const double y = (space.face(1, j) + space.face(1, j + 1)) / 2,
                 z = (space.face(2, k) + space.face(2, k + 1)) / 2;
    return std::fabs((along_z ? z : y) - slot.at_mm) < (along_z ? slot.size_mm.z : slot.size_mm.y) / 2;
}

TEST(Kits, LiftSlotsTakeWholeColumnsOfThePiecesThatAreLiftedAndKeepFarFromTheItems) {
    int slotted = 0, without = 0;
    for (int seed = 0; seed < test::cases(120, 20); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 91000);
        Kit kit = random_kit(random);
        kit.design.fit.lift = LiftOptions{random.between(10, 60), random.between(5, 25)};
        const Packing with = pack(kit.objects, checked(kit.design).value()).value_or(Packing{});
        kit.design.fit.lift.reset();
        const Packing plain = pack(kit.objects, checked(kit.design).value()).value_or(Packing{});
        if (!with.foams) continue;
        const DesignSpace& space = with.space;
        const double between = std::max(wanted_between_mm(kit.design.space), 1e-9);
        without += static_cast<int>(with.lift.without.size());
        slotted += static_cast<int>(with.lift.slots.size());
        EXPECT_EQ(with.lift.slots.size() + 2 * with.lift.without.size(),
                  2 * (with.foams->pieces.size() - (with.foams->open() ? 0 : 1)));
        for (const Piece piece : with.foams->all()) {
            const Grid<snug::Run>& cut = with.foams->piece(piece);
            const Grid<snug::Run>& whole = plain.foams->piece(piece);
            double taken = 0, said = 0;
            for (const LiftSlot& slot : with.lift.slots)
                if (slot.piece == piece) said += slot.size_mm.y * slot.size_mm.z;
            for (int j = 0; j < cut.ny(); ++j)
                for (int k = 0; k < cut.nz(); ++k) {
                    if (cut(j, k) == whole(j, k)) continue;
                    ASSERT_TRUE(cut(j, k).none());
                    taken += space.block_mm.y * space.block_mm.z;
                    ASSERT_TRUE(std::any_of(with.lift.slots.begin(), with.lift.slots.end(),
                                            [&](const LiftSlot& slot) {
                                                return slot.piece == piece && in_slot(slot, space, j, k);
                                            }));
                    for (const BlockMap& layer : with.layers)
                        for (int j2 = 0; j2 < cut.ny(); ++j2)
                            for (int k2 = 0; k2 < cut.nz(); ++k2) {
                                if (layer(j2, k2).none()) continue;
                                const double dy = (std::abs(j - j2) - 1) * space.block_mm.y,
                                             dz = (std::abs(k - k2) - 1) * space.block_mm.z;
                                ASSERT_GE(std::max(dy, dz), between - 1e-6);
                            }
                }
            EXPECT_NEAR(taken, said, 1e-6);
        }
    }
    EXPECT_GT(slotted, 10);
    EXPECT_GT(without, 0);
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
    EXPECT_TRUE(std::equal(row.layers.begin(), row.layers.end(), again.layers.begin(), again.layers.end()));
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
