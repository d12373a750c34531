// What several items meet in a drop, once more from the files that a person gets and from nothing of the
// library but their places: the foams' STL crossed by lines of a grid of its own, pockets as clipped
// triangles have them, and all masses integrated together (Runge and Kutta, small equal steps).

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "snug/check/gravity.h"
#include "snug/design/known_foams.h"
#include "snug/make.h"

#include "tests/support/brute_force.h"
#include "tests/support/cases.h"
#include "tests/support/foams_of_files.h"
#include "tests/support/random.h"
#include "tests/support/random_design.h"
#include "tests/support/random_options.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

using test::corners_of;
using test::foams_of_files;
using test::Spring;

constexpr int kLinesOfKit = 260;
constexpr int kOfCase = -1;

/// The force between two bodies over how near they came, in equal steps.
class ForceOfSprings {
  public:
    explicit ForceOfSprings(const std::vector<Spring>& springs, const StressCurve& curve) {
        for (const Spring& spring : springs)
            end_ = std::min(end_, spring.gap + spring.thickness * curve.greatest_strain());
        for (int i = 0; i <= kSteps; ++i) {
            double newton = 0;
            for (const auto& [gap, thickness, area] : springs)
                newton += area * curve.at((end_ * i / kSteps - gap) / thickness).kpa * 1e-3;
            newton_.push_back(newton);
        }
    }
    [[nodiscard]] double newton(double near) const {
        if (near <= 0) return 0;
        const double at = std::min(near / end_, 1.0) * kSteps;
        const auto i = std::min(static_cast<std::size_t>(at), newton_.size() - 2);
        return newton_[i] + (newton_[i + 1] - newton_[i]) * (at - static_cast<double>(i));
    }
    [[nodiscard]] double end() const { return end_; }

  private:
    static constexpr int kSteps = 250;
    double end_ = 1e9;
    std::vector<double> newton_;
};

struct Between {
    int rear, front;  ///< items by the way that they fall; the front may be the case, the rear too
    ForceOfSprings force;
};

/// Items that reach one another have the same number.
std::vector<int> sets_of(const std::vector<Between>& contacts, std::size_t count) {
    std::vector<int> set(count);
    for (std::size_t i = 0; i < count; ++i) set[i] = static_cast<int>(i);
    for (std::size_t round = 0; round < count; ++round)
        for (const Between& each : contacts) {
            if (each.rear < 0 || each.front < 0) continue;
            int &a = set[static_cast<std::size_t>(each.rear)], &b = set[static_cast<std::size_t>(each.front)];
            a = b = std::min(a, b);
        }
    return set;
}

/// The greatest G of each item until all that it reaches have turned round; none where something is squeezed
/// beyond the data.
std::optional<std::vector<double>> shocks_of(const std::vector<Between>& contacts,
                                             const std::vector<double>& kg, double height_mm) {
    const double gravity = kStandardGravity * 1e3, begun = std::sqrt(2 * gravity * height_mm), dt = 1e-5;
    const std::size_t count = kg.size();
    std::vector<double> state(2 * count, 0.0), most(count, 0.0);
    for (std::size_t i = 0; i < count; ++i) state[count + i] = begun;
    bool beyond = false;
    const auto forces = [&](const std::vector<double>& at) {
        std::vector<double> push(count, 0.0);
        for (const Between& each : contacts) {
            const auto place = [&](int item) { return item < 0 ? 0 : at[static_cast<std::size_t>(item)]; };
            const double near = place(each.rear) - place(each.front);
            beyond = beyond || near > each.force.end();
            const double newton = each.force.newton(near);
            if (each.rear >= 0) push[static_cast<std::size_t>(each.rear)] += newton;
            if (each.front >= 0) push[static_cast<std::size_t>(each.front)] -= newton;
        }
        return push;
    };
    const auto change = [&](const std::vector<double>& at) {
        const auto push = forces(at);
        std::vector<double> rate(2 * count);
        for (std::size_t i = 0; i < count; ++i) {
            rate[i] = at[count + i];
            rate[count + i] = gravity - push[i] * 1e3 / kg[i];
        }
        return rate;
    };
    const auto moved = [](std::vector<double> at, const std::vector<double>& rate, double by) {
        for (std::size_t i = 0; i < at.size(); ++i) at[i] += rate[i] * by;
        return at;
    };
    const std::vector<int> set = sets_of(contacts, count);
    std::vector<bool> turned(count, false);
    const auto still_falls = [&](std::size_t item) {
        for (std::size_t i = 0; i < count; ++i)
            if (set[i] == set[item] && !turned[i]) return true;
        return false;
    };
    for (int step = 0; step < 60000; ++step) {
        const auto a = change(state), b = change(moved(state, a, dt / 2)),
                   c = change(moved(state, b, dt / 2)), d = change(moved(state, c, dt));
        for (std::size_t i = 0; i < state.size(); ++i)
            state[i] += (a[i] + 2 * b[i] + 2 * c[i] + d[i]) * dt / 6;
        const auto push = forces(state);
        if (beyond) return {};
        for (std::size_t i = 0; i < count; ++i)
            if (still_falls(i)) most[i] = std::max(most[i], push[i]);
        for (std::size_t i = 0; i < count; ++i)
            if (state[count + i] <= 0) turned[i] = true;
        if (std::all_of(turned.begin(), turned.end(), [](bool each) { return each; })) break;
    }
    for (std::size_t i = 0; i < count; ++i) most[i] = most[i] / (kg[i] * kStandardGravity) - 1;
    return most;
}

/// A block of the space that a place lies in.
int block_of(const DesignSpace& space, int axis, double mm) {
    const double at = (mm - space.face(axis, 0)) / space.block_mm[axis];
    return std::clamp(static_cast<int>(std::floor(at)), 0, space.blocks[axis] - 1);
}

/// Whether the way along an axis crosses a column's run of a pocket.
bool crosses(const std::vector<std::vector<Run>>& pocket, const DesignSpace& space, int axis, Vec3d from,
             Vec3d to) {
    Vec3i at{block_of(space, 0, from.x), block_of(space, 1, from.y), block_of(space, 2, from.z)};
    const int first = block_of(space, axis, from[axis] + 1e-6), last = block_of(space, axis, to[axis] - 1e-6);
    for (at[axis] = first; at[axis] <= last; ++at[axis]) {
        const Run run = pocket[static_cast<std::size_t>(at.y)][static_cast<std::size_t>(at.z)];
        if (!run.none() && at.x >= run.first && at.x < run.end) return true;
    }
    return false;
}

/// In each column the blocks from the lowest to the highest that an item cuts.
std::vector<std::vector<Run>> pocket_of(const Mesh& mesh, const Item& item, const DesignSpace& space) {
    const auto cut = test::brute_force_cut(test::placed_triangles(mesh, item.placement), space,
                                           item.cut.clearance_mm.lower, item.cut.cut_on_touch);
    std::vector<std::vector<Run>> runs(static_cast<std::size_t>(space.blocks.y),
                                       std::vector<Run>(static_cast<std::size_t>(space.blocks.z)));
    for (int j = 0; j < space.blocks.y; ++j)
        for (int k = 0; k < space.blocks.z; ++k) {
            int first = space.blocks.x, end = 0;
            for (int i = 0; i < space.blocks.x; ++i)
                if (cut.cut(i, j, k)) first = std::min(first, i), end = i + 1;
            if (first < end)
                runs[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)] = {
                    static_cast<std::int16_t>(first), static_cast<std::int16_t>(end)};
        }
    return runs;
}

/// A body on a line.
struct OnLine {
    double low, high;
    int item;
};

/// A kit as its files have it.
struct KitOfFiles {
    const Packing& packing;
    std::vector<std::vector<test::Corners>> bodies, foams;
    std::vector<std::vector<std::vector<Run>>> pockets;
};

using Contacts = std::map<std::pair<int, int>, std::vector<Spring>>;

Contacts contacts_along(const KitOfFiles& kit, int axis) {
    const DesignSpace& space = kit.packing.space;
    const Box3d box = space.box();
    Box3d seen = box;  // across the axis no farther than the items reach
    for (int i = 1; i < 3; ++i) {
        const int across = (axis + i) % 3;
        seen.min[across] = bounds_of(kit.packing.items).min[across];
        seen.max[across] = bounds_of(kit.packing.items).max[across];
    }
    const int b = (axis + 1) % 3, c = (axis + 2) % 3, n = kLinesOfKit;
    std::vector<test::SolidLines> through, in_foam;
    for (const auto& body : kit.bodies) through.emplace_back(body, axis, n, seen.min, seen.max);
    for (const auto& foam : kit.foams) in_foam.emplace_back(foam, axis, n, seen.min, seen.max);
    const double area = seen.size()[b] * seen.size()[c] / n / n;
    Contacts contacts;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) {
            std::vector<OnLine> line;
            for (std::size_t item = 0; item < through.size(); ++item)
                if (const auto& met = through[item].at(i, k); !met.empty())
                    line.push_back({met.front(), met.back(), static_cast<int>(item)});
            std::sort(line.begin(), line.end(), [](OnLine p, OnLine q) { return p.low < q.low; });
            const auto add = [&](int low, int high, double from, double to) {
                Vec3d at;
                at[b] = seen.min[b] + (i + 0.5) * seen.size()[b] / n;
                at[c] = seen.min[c] + (k + 0.5) * seen.size()[c] / n;
                Vec3d end = at;
                at[axis] = from;
                end[axis] = to;
                for (std::size_t other = 0; other < kit.pockets.size(); ++other)
                    if (static_cast<int>(other) != low && static_cast<int>(other) != high &&
                        crosses(kit.pockets[other], space, axis, at, end))
                        return;
                double thickness = 0;
                for (const auto& each : in_foam) thickness += each.inside(i, k, from, to);
                if (thickness > 1e-6)
                    contacts[{low, high}].push_back({to - from - thickness, thickness, area});
            };
            for (std::size_t at = 0; at < line.size(); ++at) {
                if (at == 0)
                    add(kOfCase, line[at].item, box.min[axis], line[at].low);
                else
                    add(line[at - 1].item, line[at].item, line[at - 1].high, line[at].low);
                if (at + 1 == line.size()) add(line[at].item, kOfCase, line[at].high, box.max[axis]);
            }
        }
    return contacts;
}

/// Faces of items on which both know a shock, of these in packs whose items reach one another, and more than
/// 3 % apart.
struct Counts {
    int compared = 0, together = 0, apart = 0;
};

void expect_the_same_kit(std::vector<Object> objects, const Design& design, Counts& counts) {
    Project project = test::project_of("kit", design);
    project.objects.clear();
    for (std::size_t i = 0; i < objects.size(); ++i) {
        project.objects.emplace_back();
        project.objects.back().file.name = "object" + std::to_string(i) + ".stl";
    }
    auto made = make(std::span(objects), project);
    ASSERT_TRUE(made) << text(made.error().message);
    ASSERT_TRUE(made->packing.foams);
    const Packing& packing = made->packing;
    KitOfFiles kit{packing, {}, foams_of_files(objects, project, *made), {}};
    std::vector<double> kg;
    for (const Item& item : packing.items) {
        const Mesh& mesh = objects[item.object].mesh;
        kit.bodies.push_back(corners_of(mesh, [&](Vec3f v) { return item.placement(v); }));
        kit.pockets.push_back(pocket_of(mesh, item, packing.space));
        kg.push_back(*item.mass_kg);
    }
    const StressCurve curve(project.design.protection.foam->curve);
    for (int axis = 0; axis < 3; ++axis) {
        const Contacts contacts = contacts_along(kit, axis);
        const bool any_between = std::any_of(contacts.begin(), contacts.end(), [](const auto& each) {
            return each.first.first >= 0 && each.first.second >= 0;
        });
        for (const bool high : {false, true}) {
            std::vector<Between> falling;
            for (const auto& [ends, springs] : contacts)
                falling.push_back({high ? ends.first : ends.second, high ? ends.second : ends.first,
                                   ForceOfSprings(springs, curve)});
            const auto g = shocks_of(falling, kg, *packing.protection->drop_mm);
            const auto side = static_cast<std::size_t>(2 * axis + (high ? 1 : 0));
            SCOPED_TRACE(side_name(static_cast<Side>(side)));
            for (std::size_t i = 0; g && i < kg.size(); ++i) {
                const FaceShock& face = packing.protection->items[i].faces[side];
                if (!face.g_model) continue;
                ++counts.compared;
                counts.together += any_between;
                // Where a sliver of an item stands over another, both grids see few lines of it.
                const double off = std::abs(*face.g_model / (*g)[i] - 1);
                EXPECT_LT(off, 0.06) << "item " << i;
                counts.apart += off > 0.03;
            }
        }
    }
}

TEST(ProtectionOfKits, IsWhatTheirFilesSayInLayersAndRows) {
    const int kits = test::cases(10, 1);
    Counts counts;
    for (int n = 0; n < kits; ++n) {
        test::Random random(static_cast<std::uint64_t>(700 + n));
        SCOPED_TRACE("seed " + std::to_string(700 + n));
        Design design;
        design.object.units = Unit::mm;
        design.space.blocks.reset();
        design.space.block_mm = {random.between(5, 16), random.between(5, 16), random.between(5, 16)};
        design.space.wall_mm = equal_walls(70);
        design.space.between_mm = random.between(25, 70);
        design.cut.clearance_mm = random.between(0, 2);
        design.protection.foam = find_foam(built_in_foams(), "ethafoam-200lc").value();
        design.protection.height_mm = random.between(50, 250);
        design.items.clear();
        std::vector<Object> objects;
        for (int i = random.integer(2, 4); i > 0; --i) {
            const Vec3d half{random.between(15, 40), random.between(15, 40), random.between(15, 40)};
            ItemOptions item;
            item.object = static_cast<int>(objects.size());
            item.layer = design.items.empty() ? 1 : random.integer(1, 2);
            item.mass_kg = random.between(0.2, 1.2);
            if (random.chance(0.3)) item.rotation_deg = Vec3d{0, 0, random.between(0, 90)};
            design.items.push_back(item);
            objects.push_back(prepare(random.chance(0.6) ? test::box_mesh(half * -1, half)
                                                         : test::sphere_mesh(random.between(20, 40), 30),
                                      design)
                                  .value());
        }
        expect_the_same_kit(std::move(objects), design, counts);
    }
    EXPECT_GE(counts.compared, 6 * kits);
    EXPECT_GE(counts.together, 3 * kits);
    EXPECT_LE(counts.apart * 25, counts.compared);
}

}  // namespace
}  // namespace snug
