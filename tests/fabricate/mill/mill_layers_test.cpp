#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/design/presets.h"
#include "snug/fabricate/mill/gcode.h"
#include "snug/samples/samples.h"

#include "tests/support/cases.h"
#include "tests/support/milled.h"

// Pieces between two layers, milled from both sides: what stands after both programs, against the blocks and
// the surfaces of the items above and below.

namespace snug {
namespace {

using test::GcodeStock;
using test::Random;

struct MilledKit {
    std::vector<Object> objects;
    Design design;
    Packing packing;
    [[nodiscard]] FoamDesign foams() const {
        return {packing.space, packing.layers, *packing.foams, packing.available, "kit"};
    }
    [[nodiscard]] MilledObject milled() const {
        MilledObject object;
        for (const Item& item : packing.items)
            object.surfaces.push_back({objects[item.object].mesh, item.placement, item.cut, item.layer});
        return object;
    }
};

MilledKit random_kit(Random& random, bool turned) {
    MilledKit kit;
    Design& design = kit.design;
    apply(*find_preset(built_in_presets(), "mill"), design);
    design.object.units = Unit::mm;
    design.object.longest_mm = 60;
    design.space.blocks.reset();
    design.space.wall_mm = equal_walls(25);
    design.cut.clearance_mm = Clearance{{1, 2, 2}, {2, 1, 1}};
    for (const char* name : {"vase", "camera"}) kit.objects.push_back(prepare(*sample(name), design).value());
    design.items = {{}, {}, {}};
    for (ItemOptions& item : design.items) {
        item.object = random.integer(0, 1);
        if (turned) item.rotation_deg = Vec3d{random.between(0, 90), random.between(0, 90), 0};
    }
    design.items[1].layer = 2;
    design.items[2].layer = random.integer(1, 3);
    design = checked(design).value();
    kit.packing = pack(kit.objects, design).value();
    return kit;
}

GcodeStock carved_by(const MillPlan& plan, const MillOptions& options) {
    const auto program =
        test::read_gcode(grbl_program(plan.path, plan.field.size_mm(), options, {"", ""}, {}));
    expect_sound(program, plan, options);
    return carved(program, plan, options, 0.5);
}

/// What stands of a piece after its programs, in design coordinates.
class Standing {
  public:
    Standing(const MillPlans& plans, const MillPlan& own, const FoamDesign& design,
             const MillOptions& options)
        : design_(design),
          piece_(own.piece),
          field_(own.field),
          under_(design.seen(own.piece).under),
          top_(carved_by(own, options)) {
        for (const MillPlan& plan : plans.plans)
            if (plan.outside && plan.piece == own.piece && !plan.empty())
                other_.emplace(carved_by(plan, options));
    }

    struct Foam {
        double low, high;
        [[nodiscard]] bool none() const { return high <= low + 2e-3; }
    };
    /// Along x above a place.
    [[nodiscard]] Foam at(double y, double z) const {
        const DesignSpace& space = design_.space;
        const bool lid = piece_.half() == Half::lid;
        const Vec2d size = field_.size_mm();
        const Vec2d at{z - space.face(2, 0), lid ? y - space.face(1, 0) : space.face(1, space.blocks.y) - y};
        const double high = top_.at(at),
                     low = other_ ? field_.top_mm() - other_->at({at.x, size.y - at.y}) : 0;
        if (lid) return {space.face(0, space.blocks.x) - high, space.face(0, space.blocks.x) - low};
        const double base = space.face(0, under_);
        return {base + low, base + high};
    }

  private:
    const FoamDesign& design_;
    Piece piece_;
    const MillField& field_;
    int under_;
    GcodeStock top_;
    std::optional<GcodeStock> other_;
};

/// No foam of the piece where an item of a layer above or below needs room, at corners of its surface.
void expect_clear(const Standing& standing, const MilledKit& kit, Piece piece, Random& random) {
    for (const Item& item : kit.packing.items) {
        const bool above = item.layer > piece.index;
        const Vec3d e = above ? item.cut.whole_clearance_mm().lower : item.cut.whole_clearance_mm().upper;
        const Mesh& mesh = kit.objects[item.object].mesh;
        for (int i = 0; i < 20000; ++i) {
            const auto& triangle = mesh.triangles[static_cast<std::size_t>(
                random.integer(0, static_cast<int>(mesh.triangles.size()) - 1))];
            const Vec3d p = item.placement(mesh.vertices[triangle[0]]);
            const double y = p.y + random.between(-1, 1) * (e.y - 0.02),
                         z = p.z + random.between(-1, 1) * (e.z - 0.02);
            const Standing::Foam foam = standing.at(y, z);
            if (foam.none()) continue;
            if (above)
                ASSERT_LE(foam.high, p.x - e.x + 0.02) << piece.index << " below layer " << item.layer;
            else
                ASSERT_GE(foam.low, p.x + e.x - 0.02) << piece.index << " above layer " << item.layer;
        }
    }
}

/// The middles of columns that the cutter enters hold the blocks.
int right_columns(const Standing& standing, const MilledKit& kit, Piece piece) {
    const DesignSpace& space = kit.packing.space;
    const Grid<snug::Run>& kept = kit.packing.foams->piece(piece);
    int right = 0;
    for (int j = 0; j < kept.ny(); ++j)
        for (int k = 0; k < kept.nz(); ++k) {
            const Standing::Foam foam = standing.at((space.face(1, j) + space.face(1, j + 1)) / 2,
                                                    (space.face(2, k) + space.face(2, k + 1)) / 2);
            const snug::Run run = kept(j, k);
            right += run.none() ? foam.none()
                                : std::abs(foam.low - space.face(0, run.first)) < 2e-3 &&
                                      std::abs(foam.high - space.face(0, run.end)) < 2e-3;
        }
    return right;
}

TEST(MillLayersTest, BothSidesOfEveryPieceLeaveRoomForTheItemsAboveAndBelow) {
    bool pinned = false;
    for (int seed = 0; seed < test::cases(4, 2); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(400 + static_cast<std::uint64_t>(seed));
        const MilledKit kit = random_kit(random, seed % 2 == 0);
        ASSERT_TRUE(kit.packing.foams);
        MillOptions options;
        options.flute_mm = 300;
        options.pin_mm = seed == 0 ? 0 : 6;
        const FoamDesign design = kit.foams();
        const auto plans = mill_plans(design, kit.milled(), options);
        ASSERT_TRUE(plans) << snug::text(plans.error().message);
        for (const Piece piece : kit.packing.foams->all()) {
            const Standing standing(*plans, plans->plans[static_cast<std::size_t>(piece.index)], design,
                                    options);
            expect_clear(standing, kit, piece, random);
            const int columns = kit.packing.space.blocks.y * kit.packing.space.blocks.z;
            EXPECT_GT(right_columns(standing, kit, piece), 0.85 * columns) << piece.index;
        }
        if (options.pin_mm == 0 || plans->no_room_for_pins) continue;
        pinned = true;
        for (const MillPlan& plan : plans->plans) {
            const bool meets = !plan.outside || plan.piece.middle();
            EXPECT_EQ(plan.pins.size(), meets ? 2u : 0u);
        }
    }
    EXPECT_TRUE(pinned);
}

}  // namespace
}  // namespace snug
