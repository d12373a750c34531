#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <sys/resource.h>
#include <tbb/global_control.h>
#include <thread>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "snug/depth/depth_map.h"
#include "snug/design/design.h"
#include "snug/foam/block_map.h"
#include "snug/foam/foams.h"
#include "snug/foam/parting.h"
#include "snug/formats/mesh_files.h"
#include "snug/make.h"
#include "snug/object/prepared_surface.h"

#include "bench/measure_times.h"
#include "bench/objects.h"
#include "bench/paper_method.h"

// From a placement to two foams: the paper's method, a plain exact loop over all triangles, and Snug, by
// turns in one run over the same random rotations. Prints JSON, which report.py makes into
// docs/benchmarks.md. Usage: method_times FOLDER (where the largest object is left for the WebAssembly run)

namespace snug::bench {
namespace {

using nlohmann::json;

constexpr int kRotations = 20;
constexpr int kTexels = 1024;
const Reach kReach = reach(0, false);

DesignSpace space_of(int columns, int layers) {
    const double side = kDiagonal * 1.1;
    return {{layers, columns, columns}, {side / layers, side / columns, side / columns}};
}

Foams foams_of(const DepthMap& depths, const DesignSpace& space, const Placement& placement) {
    const BlockMap blocks = block_map(depths, space, kReach);
    return split(blocks, space, auto_parting_level(blocks, space, placement.bounds));
}

/// One object in one space, each method in its turn at each rotation.
struct Contest {
    const Mesh& mesh;
    const PreparedSurface& prepared;
    PaperMethod& paper;

    [[nodiscard]] json run(const DesignSpace& space, int count) const {
        std::vector<double> by_paper, by_loop, by_snug, by_threads;
        std::size_t columns = 0, equal = 0;
        for (const Vec3d& rotation : rotations(count)) {
            const Placement placement = place(mesh, rotation, {});
            DepthMap sampled, exact;
            by_paper.push_back(time_of([&] {
                sampled = paper.depth_map(placement, space);
                (void)foams_of(sampled, space, placement);
            }));
            {
                const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
                by_loop.push_back(time_of([&] {
                    const Placement placed = place(mesh, rotation, {});
                    exact = depth_map(mesh, placed, space, kReach);
                    (void)foams_of(exact, space, placed);
                }));
                by_snug.push_back(time_of([&] { from_placement(rotation, space); }));
            }
            by_threads.push_back(time_of([&] { from_placement(rotation, space); }));
            const BlockMap a = block_map(sampled, space, kReach), b = block_map(exact, space, kReach);
            columns += a.size();
            for (std::size_t i = 0; i < a.size(); ++i) equal += a[i] == b[i];
        }
        return {{"paper", summary(by_paper)},
                {"loop", summary(by_loop)},
                {"snug", summary(by_snug)},
                {"threads", summary(by_threads)},
                {"blocks", {space.blocks.x, space.blocks.y, space.blocks.z}},
                {"paper_columns_equal", static_cast<double>(equal) / static_cast<double>(columns)}};
    }

    void from_placement(Vec3d rotation, const DesignSpace& space) const {
        const Placement placement = place(prepared, rotation, {});
        (void)foams_of(depth_map(prepared, placement, space, kReach), space, placement);
    }
};

/// `large`: one of the two that the claims are about. `growth`: with the layers, too.
json contests(const NamedMesh& object, bool large, bool growth) {
    std::vector<double> preparing, preparing_alone;
    PreparedSurface prepared;
    for (int i = 0; i < 5; ++i) {
        preparing.push_back(time_of([&] { prepared = prepare_surface(object.mesh); }));
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        preparing_alone.push_back(time_of([&] { prepared = prepare_surface(object.mesh); }));
    }
    PaperMethod paper(object.mesh, kTexels);
    const Contest contest{object.mesh, prepared, paper};
    json runs = json::array();
    const std::vector<int> resolutions =
        large ? std::vector{10, 15, 20, 25, 30, 100, 300} : std::vector{10, 15, 20, 25, 30};
    for (const int resolution : resolutions) {
        const bool full = large && (resolution == 10 || resolution == 30 || resolution == 300);
        runs.push_back(contest.run(space_of(resolution, resolution), full ? kRotations : 5));
    }
    json by_layers = json::array();
    if (growth)
        for (const int layers : {10, 100, 1000, 4096})
            by_layers.push_back(contest.run(space_of(30, layers), 5));
    return {{"name", object.name},
            {"vertices", object.mesh.vertices.size()},
            {"triangles", object.mesh.triangles.size()},
            {"renderer", paper.renderer()},
            {"prepare", summary(preparing)},
            {"prepare_one_thread", summary(preparing_alone)},
            {"runs", runs},
            {"layers", by_layers}};
}

/// The whole of snug::pack, as the studio calls it; the same designs go to WebAssembly.
json packs(const Mesh& mesh) {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    json result = json::array();
    for (const int columns : {30, 300}) {
        Design design;
        design.object.units = Unit::mm;
        const DesignSpace space = space_of(columns, 30);
        design.space.blocks = space.blocks;
        design.space.block_mm = space.block_mm;
        Object object = *prepare(mesh, design);
        object.prepared = prepare_surface(object.mesh);
        std::vector<double> times;
        for (const Vec3d& rotation : rotations(kRotations)) {
            design.placement.rotation_deg = rotation;
            times.push_back(time_of([&] { (void)pack(object, design); }));
        }
        result.push_back({{"columns", columns}, {"time", summary(times)}});
    }
    return result;
}

int run(const char* folder) {
    json report{{"threads", std::thread::hardware_concurrency()},
                {"compiler", __VERSION__},
                {"objects", json::array()}};
    const std::vector<NamedMesh> all = objects();
    for (const NamedMesh& object : all) {
        fmt::print(stderr, "{}: {} vertices\n", object.name, object.mesh.vertices.size());
        report["objects"].push_back(contests(object, &object >= &all.back() - 1, &object == &all.back()));
    }
    const Mesh& largest = all.back().mesh;
    report["pack"] = packs(largest);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    report["peak_mb"] = static_cast<double>(usage.ru_maxrss) / 1024;
    const FileBytes ply = write_ply(largest.vertices, largest.triangles, {});
    std::ofstream(std::string(folder) + "/largest.ply", std::ios::binary)
        .write(reinterpret_cast<const char*>(ply.data()), static_cast<std::streamsize>(ply.size()));
    json angles = json::array();
    for (const Vec3d& rotation : rotations(kRotations))
        angles.push_back({rotation.x, rotation.y, rotation.z});
    report["rotations"] = angles;
    std::puts(report.dump(1).c_str());
    return 0;
}

}  // namespace
}  // namespace snug::bench

int main(int argc, char** argv) {
    // Before Mesa starts its threads: the paper's method runs on one.
    setenv("LP_NUM_THREADS", "0", 1);
    return argc == 2 ? snug::bench::run(argv[1]) : 1;
}
