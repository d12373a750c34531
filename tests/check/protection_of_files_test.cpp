// What an item meets in a drop, once more from the files that a person gets: the foams' STL, read back and
// crossed by lines of a grid of its own, springs summed one by one and the balance found by halving.

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "snug/check/gravity.h"
#include "snug/check/protection.h"
#include "snug/design/known_foams.h"
#include "snug/make.h"
#include "snug/samples/samples.h"

#include "tests/support/cases.h"
#include "tests/support/foams_of_files.h"
#include "tests/support/random.h"
#include "tests/support/random_options.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

constexpr int kLines = 240;

using test::corners_of;
using test::foams_of_files;
using test::Spring;

/// The G of a fall onto springs, each of a stress that is given; none where one is squeezed beyond the data.
std::optional<double> g_of_fall(const std::vector<Spring>& springs, const StressCurve& curve, double kg,
                                double height_mm) {
    double low = 0, high = 1e9;
    for (const Spring& spring : springs)
        high = std::min(high, spring.gap + spring.thickness * curve.greatest_strain());
    const auto lacking = [&](double travel) {
        double taken = 0;
        for (const auto& [gap, thickness, area] : springs)
            taken += area * thickness * curve.at((travel - gap) / thickness).energy * 1e-6;
        return kg * kStandardGravity * (height_mm + travel) * 1e-3 - taken;
    };
    if (springs.empty() || lacking(high) > 0) return {};
    for (int i = 0; i < 50; ++i) {
        const double middle = (low + high) / 2;
        (lacking(middle) > 0 ? low : high) = middle;
    }
    double newton = 0;
    for (const auto& [gap, thickness, area] : springs)
        newton += area * curve.at((high - gap) / thickness).kpa * 1e-3;
    return newton / (kg * kStandardGravity) - 1;
}

/// Counts the faces on which both know a shock.
void expect_the_same(const Mesh& mesh, Design design, int& compared) {
    Project project = test::project_of("object", std::move(design));
    auto object = prepare(mesh, project.design);
    ASSERT_TRUE(object);
    auto made = make(*object, project);
    ASSERT_TRUE(made) << made.error().message.code;
    ASSERT_TRUE(made->packing.protection);
    const Packing& packing = made->packing;
    const Item& item = packing.items.front();
    const auto body = corners_of(object->mesh, [&](Vec3f v) { return item.placement(v); });
    const auto foams = foams_of_files(std::span(&*object, 1), project, *made);
    const Box3d box = packing.space.box();
    const StressCurve curve(project.design.protection.foam->curve);
    const double kg = *item.mass_kg;
    for (int axis = 0; axis < 3; ++axis) {
        const int b = (axis + 1) % 3, c = (axis + 2) % 3;
        const test::SolidLines through(body, axis, kLines, box.min, box.max);
        std::vector<test::SolidLines> in_foam;
        for (const auto& foam : foams) in_foam.emplace_back(foam, axis, kLines, box.min, box.max);
        const double area = box.size()[b] * box.size()[c] / kLines / kLines;
        for (const bool high : {false, true}) {
            std::vector<Spring> springs;
            for (int i = 0; i < kLines; ++i)
                for (int k = 0; k < kLines; ++k) {
                    const auto& line = through.at(i, k);
                    if (line.empty()) continue;
                    const double from = high ? line.back() : box.min[axis],
                                 to = high ? box.max[axis] : line.front();
                    double thickness = 0;
                    for (const test::SolidLines& each : in_foam) thickness += each.inside(i, k, from, to);
                    if (thickness > 1e-6) springs.push_back({to - from - thickness, thickness, area});
                }
            const auto side = static_cast<std::size_t>(2 * axis + (high ? 1 : 0));
            const FaceShock& face = made->packing.protection->items.front().faces[side];
            if (face.why_none == NoShock::thin) continue;
            const auto g = g_of_fall(springs, curve, kg, *made->packing.protection->drop_mm);
            SCOPED_TRACE(side_name(static_cast<Side>(side)));
            // A single line decides what bottoms, and the two grids have others.
            if (!g || !face.g_model) continue;
            ++compared;
            EXPECT_NEAR(*face.g_model / *g, 1, 0.03);
        }
    }
}

Design drop_design(double kg, double height_mm) {
    Design design;
    design.object.units = Unit::mm;
    design.space.blocks.reset();
    design.space.block_mm = {10, 10, 10};
    design.space.wall_mm = equal_walls(70);
    design.protection.foam = find_foam(built_in_foams(), "ethafoam-200lc").value();
    design.protection.height_mm = height_mm;
    design.workshop.mass_kg = kg;
    return design;
}

TEST(ProtectionOfFiles, OfSamplesIsWhatTheirFoamsSay) {
    int compared = 0;
    for (const auto& [name, kg] :
         {std::pair{"camera", 0.5}, std::pair{"vase", 1.2}, std::pair{"figurine", 0.2}}) {
        SCOPED_TRACE(name);
        expect_the_same(*sample(name), drop_design(kg, 200), compared);
    }
    EXPECT_GE(compared, 15) << "of 18 faces";
}

TEST(ProtectionOfFiles, OfRandomDesignsIsWhatTheirFoamsSay) {
    const int designs = test::cases(40, 4);
    int compared = 0;
    for (int i = 0; i < designs; ++i) {
        test::Random random(static_cast<std::uint64_t>(300 + i));
        SCOPED_TRACE("seed " + std::to_string(300 + i));
        Design design = drop_design(random.between(0.3, 1.5), random.between(50, 300));
        design.space.block_mm = {random.between(4, 18), random.between(4, 18), random.between(4, 18)};
        design.cut.clearance_mm = random.between(0, 3);
        design.placement.rotation_deg = {random.between(0, 360), random.between(0, 360),
                                         random.between(0, 360)};
        const Vec3d half{random.between(15, 60), random.between(15, 60), random.between(15, 60)};
        expect_the_same(random.chance(0.5) ? test::box_mesh(half * -1, half)
                                           : test::sphere_mesh(random.between(25, 60), 40),
                        design, compared);
    }
    EXPECT_GE(compared, 3 * designs) << "of six faces each";
}

}  // namespace
}  // namespace snug
