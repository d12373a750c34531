#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "snug/fabricate/solid.h"
#include "snug/foam/block_map.h"
#include "snug/foam/foam_pair.h"
#include "snug/foam/parting.h"
#include "snug/mesh/read.h"
#include "snug/mesh/samples.h"

#include "bench/refine.h"

// Time per stage of the method, one thread, over 20 random rotations. The paper publishes 135 to 143 ms at
// 30 x 30 x 30 for its two largest scans, of about 690,000 vertices (table 1).

namespace snug::bench {
namespace {

constexpr double kDiagonal = 240;  // mm
constexpr int kRotations = 20;

/// The shared armadillo refined twice (691,858 vertices), or the figurine refined three times where it is
/// absent.
Mesh large_object() {
    const char* models = std::getenv("SNUG_MODELS");
    const std::string folder = models ? models : SNUG_SOURCE_DIR "/../shared/models";
    std::ifstream file(folder + "/armadillo.obj", std::ios::binary);
    std::string text((std::istreambuf_iterator<char>(file)), {});
    Mesh mesh;
    if (auto read = read_obj(std::as_bytes(std::span(text))); !text.empty() && read)
        mesh = refined(refined(*read));
    else
        mesh = refined(refined(*sample("figurine")));
    const Vec3d size = bounds(mesh).size();
    return scaled(std::move(mesh), kDiagonal / std::sqrt(dot(size, size)));
}

const Mesh& object() {
    static const Mesh mesh = large_object();
    return mesh;
}

Vec3d rotation(int number) {
    return {number * 137.5, number * 71.3, number * 33.7};
}

DesignSpace space_of(int columns, int layers) {
    const double side = kDiagonal * 1.1;
    return {{layers, columns, columns}, {side / layers, side / columns, side / columns}};
}

void depth_map_stage(benchmark::State& state) {
    const DesignSpace space = space_of(static_cast<int>(state.range(0)), static_cast<int>(state.range(0)));
    int number = 0;
    for (auto unused : state) {
        const Placement placement = place(object(), rotation(number++ % kRotations), {});
        benchmark::DoNotOptimize(depth_map(object(), placement, space, reach(0, false)));
    }
    state.counters["vertices"] = static_cast<double>(object().vertices.size());
}

void blocks_parting_and_foams_stage(benchmark::State& state) {
    const DesignSpace space = space_of(static_cast<int>(state.range(0)), static_cast<int>(state.range(0)));
    const Placement placement = place(object(), rotation(3), {});
    const DepthMap depths = depth_map(object(), placement, space, reach(0, false));
    for (auto unused : state) {
        const BlockMap blocks = block_map(depths, space, reach(0, false));
        benchmark::DoNotOptimize(split(blocks, space, auto_parting_level(blocks, space, placement.bounds)));
    }
}

void solids_stage(benchmark::State& state) {
    const DesignSpace space = space_of(static_cast<int>(state.range(0)), static_cast<int>(state.range(0)));
    const Placement placement = place(object(), rotation(3), {});
    const BlockMap blocks =
        block_map(depth_map(object(), placement, space, reach(0, false)), space, reach(0, false));
    const FoamPair foams = split(blocks, space, auto_parting_level(blocks, space, placement.bounds));
    for (auto unused : state) {
        benchmark::DoNotOptimize(lower_solid(foams, space));
        benchmark::DoNotOptimize(upper_solid(foams, space));
    }
}

void stages(benchmark::internal::Benchmark* bench) {
    for (const int resolution : {10, 30, 100, 300}) bench->Arg(resolution);
    bench->Unit(benchmark::kMillisecond)->Repetitions(5)->ReportAggregatesOnly();
}

BENCHMARK(depth_map_stage)->Apply(stages);
BENCHMARK(blocks_parting_and_foams_stage)->Apply(stages);
BENCHMARK(solids_stage)->Apply(stages);

}  // namespace
}  // namespace snug::bench

BENCHMARK_MAIN();
