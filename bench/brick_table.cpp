#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "snug/fabricate/bricks/brick_forces.h"
#include "snug/fabricate/bricks/brick_layout.h"
#include "snug/fabricate/bricks/brick_shape.h"
#include "snug/fabricate/bricks/brick_springs.h"
#include "snug/fabricate/bricks/brick_statics.h"
#include "snug/make.h"
#include "snug/samples/samples.h"

#include "bench/brick_graph.h"
#include "bench/measure_times.h"
#include "bench/objects.h"
#include "bench/random_merge.h"
#include "cli/clp_solver.h"

// Foams of bricks: our layout beside the random merge of Luo et al., both of Luo's bricks, on the objects and
// resolutions of Fukusato and Kita's paper and at 30 x 18 x 18; and how long it takes to know that they hold.

namespace snug::bench {
namespace {

using json = nlohmann::json;
constexpr Vec3d kBlock{9.6, 8, 8};  // mm, one brick of one stud
constexpr int kSeeds = 5;
constexpr double kCapacity = 0.7;      // newtons a contact point
constexpr int kMostForProgram = 1000;  // studs of a half: above, both layouts have the springs' figure

struct Case {
    const char* object;  ///< a shared model, or a sample
    const char* file;    ///< none: the sample
    Vec3i blocks;
};
constexpr Case kCases[] = {
    {"torus", nullptr, {8, 8, 8}},
    {"bunny", "stanford-bunny.obj", {12, 8, 8}},
    {"armadillo", "armadillo.obj", {6, 10, 10}},
    {"torus", nullptr, {30, 18, 18}},
    {"bunny", "stanford-bunny.obj", {30, 18, 18}},
    {"armadillo", "armadillo.obj", {30, 18, 18}},
};

/// The foams of an object that leaves a block on every side.
std::optional<Packing> packing_of(const Case& each) {
    std::optional<Mesh> mesh = each.file ? shared_model(each.file) : std::nullopt;
    if (each.file && !mesh) return {};
    if (!mesh) mesh = *sample(each.object);
    const Vec3d size = bounds(*mesh).size();
    double scale = kUnbounded;
    for (int axis = 0; axis < 3; ++axis)
        scale = std::min(scale, (each.blocks[axis] - 2) * kBlock[axis] / size[axis]);
    Design design;
    design.object.units = Unit::mm;
    design.space.blocks = each.blocks;
    design.space.block_mm = kBlock;
    const auto object = prepare(scaled(std::move(*mesh), scale), design);
    if (!object) return {};
    auto packing = pack(*object, design);
    if (!packing || !packing->foams) return {};
    return std::move(*packing);
}

BrickSupports supports_of(const BrickBuild& build, BrickLoad load) {
    return brick_supports(build, brick_joints(build), load);
}

/// Share of the capacity that the weakest joint needs.
json strength_of(const BrickBuild& build, BrickLoad load, bool exact) {
    const auto joints = brick_joints(build);
    const BrickSupports supports = supports_of(build, load);
    json result{{"load", brick_load_name(load)}};
    if (const auto loose = loose_bricks(supports, joints); !loose.empty()) {
        result["loose"] = loose.size();
        return result;
    }
    std::optional<double> grip;
    if (exact) {
        const BrickForces forces = brick_forces(build, joints, supports, ForceModel::full);
        const auto solution = clp_solver()(equilibrium(build, supports, forces), {});
        if (solution && solution->feasible) grip = solution->x.front();
    } else {
        const BrickForces forces = brick_forces(build, joints, supports, ForceModel::upright);
        const auto x = spring_forces(build, joints, supports, forces);
        if (x && !x->empty()) grip = x->front();
    }
    if (grip) result["used"] = *grip * kNewtonsPerGram / kCapacity;
    return result;
}

json layout_of(const BrickBuild& build, double ms, bool exact) {
    json loads = json::array();
    for (const BrickLoad load : {BrickLoad::lifted, BrickLoad::turned})
        loads.push_back(strength_of(build, load, exact));
    return {{"bricks", build.bricks.size()},
            {"pieces", piece_count(build)},
            {"articulations", articulation_bricks(build)},
            {"loads", loads},
            {"ms", ms}};
}

BrickHeights heights_of(const BrickShape& shape) {
    BrickHeights heights(shape.rows(), shape.columns());
    for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = static_cast<std::uint16_t>(shape.top[i]);
    return heights;
}

json random_layouts(const BrickShape& shape, bool exact) {
    json runs = json::array();
    for (int seed = 1; seed <= kSeeds; ++seed) {
        BrickBuild build;
        const BrickHeights heights = heights_of(shape);
        const MergeOptions options{BrickKind::brick, luo_family(), static_cast<std::uint64_t>(seed)};
        const double ms = time_of([&] { build = random_merge(heights, options); });
        runs.push_back(layout_of(build, ms, exact));
    }
    return runs;
}

json our_layout(const BrickShape& shape, bool exact) {
    BrickOptions options;
    for (const BrickSize& size : luo_family())
        options.family.push_back(std::to_string(size.width) + "x" + std::to_string(size.length));
    std::optional<BrickBuild> build;
    const double ms = time_of([&] {
        BrickBox box(options);
        auto made = brick_layout(shape, BrickRim::studs, box);
        if (made) build = std::move(made->build);
    });
    return build ? layout_of(*build, ms, exact) : json();
}

json case_of(const Case& each) {
    const auto packing = packing_of(each);
    if (!packing) return {};
    const FoamDesign design{packing->space, packing->layers, *packing->foams, packing->available,
                            each.object};
    json halves = json::array();
    for (const Half half : {Half::lower, Half::lid}) {
        const BrickShape shape = brick_shape(design, half, {1, 1, kPlatesInBrick}, kPlatesInBrick);
        const bool exact = shape.studs() <= kMostForProgram;
        halves.push_back({{"exact", exact},
                          {"half", half == Half::lower ? "lower" : "lid"},
                          {"studs", shape.studs()},
                          {"random", random_layouts(shape, exact)},
                          {"snug", our_layout(shape, exact)}});
    }
    return {{"object", each.object},
            {"blocks", {each.blocks.x, each.blocks.y, each.blocks.z}},
            {"halves", halves}};
}

/// A block with a bowl in it: what any number of bricks can be had from.
BrickShape bowl(int rows, int columns, int layers) {
    BrickShape shape;
    shape.top = Grid<int>(rows, columns, layers);
    shape.first = Grid<int>(rows, columns);
    shape.rim = Grid<char>(rows, columns);
    const auto along = [](int i, int count) { return (i + 0.5 - count / 2.0) / (count / 2.0 - 2); };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double a = along(row, rows), b = along(column, columns), inside = 1 - a * a - b * b;
            if (inside > 0)
                shape.top(row, column) =
                    std::max(1, static_cast<int>(std::ceil(layers - (layers - 1) * std::sqrt(inside))));
            else
                shape.rim(row, column) = 1;
        }
    return shape;
}

/// How long a bowl's check takes by springs, until a tenth of the capacity does, and by the program.
json check_of(int rows, int columns, int layers, bool program) {
    BrickBox box{BrickOptions{}};
    const auto layout = brick_layout(bowl(rows, columns, layers), BrickRim::studs, box);
    if (!layout) return {};
    const BrickBuild& build = layout->build;
    const auto joints = brick_joints(build);
    json loads = json::array();
    for (const BrickLoad load : {BrickLoad::lifted, BrickLoad::turned}) {
        const BrickSupports supports = supports_of(build, load);
        const auto share = [](double grip) { return grip * kNewtonsPerGram / kCapacity; };
        json one{{"load", brick_load_name(load)}};
        one["springs_ms"] = time_of([&] {
            const BrickForces forces = brick_forces(build, joints, supports, ForceModel::upright);
            const auto x = spring_forces(build, joints, supports, forces, 0.1 * kCapacity / kNewtonsPerGram);
            if (x && !x->empty()) one["springs_used"] = share(x->front());
        });
        if (program)
            one["program_ms"] = time_of([&] {
                const BrickForces forces = brick_forces(build, joints, supports, ForceModel::full);
                const LinearProgram lp = equilibrium(build, supports, forces);
                one["rows"] = lp.rows();
                one["columns"] = lp.columns();
                const auto solution = clp_solver()(lp, {});
                if (solution && solution->feasible) one["program_used"] = share(solution->x.front());
            });
        loads.push_back(std::move(one));
    }
    return {{"bricks", build.bricks.size()}, {"loads", loads}};
}

}  // namespace
}  // namespace snug::bench

int main() {
    using namespace snug::bench;
    json layouts = json::array(), checks = json::array();
    for (const Case& each : kCases)
        if (json made = case_of(each); !made.is_null()) layouts.push_back(std::move(made));
    checks.push_back(check_of(24, 16, 8, true));
    checks.push_back(check_of(32, 24, 12, true));
    checks.push_back(check_of(48, 32, 16, true));
    checks.push_back(check_of(72, 48, 18, false));
    checks.push_back(check_of(96, 64, 32, false));
    std::puts(json{{"layouts", layouts}, {"checks", checks}}.dump(1).c_str());
    return 0;
}
