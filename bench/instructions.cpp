#include <cstdio>
#include <string_view>
#include <tbb/global_control.h>
#include <vector>

#include "snug/depth/depth_map.h"
#include "snug/foam/block_map.h"
#include "snug/formats/mesh_files.h"
#include "snug/formats/read.h"
#include "snug/object/prepared_surface.h"
#include "snug/samples/samples.h"

#include "bench/refine.h"

// Fixed work on what Snug generates, for callgrind: instructions are counted inside measured() alone. See
// tests/instruction_counts.py.
// Usage: snug_instructions CASE

namespace {

using namespace snug;

template <class Work>
__attribute__((noinline)) void measured(const Work& work) {
    work();
}

const Reach kReach = reach(0, false);

DesignSpace space_of(int columns) {
    const double side = 290;
    return {{30, columns, columns}, {side / 30, side / columns, side / columns}};
}

/// Keeps the compiler from leaving work out.
std::size_t cut_columns(const DepthMap& depths) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < depths.size(); ++i) count += !depths[i].none();
    return count;
}

std::size_t placements(const PreparedSurface& surface, int columns) {
    std::size_t count = 0;
    for (int i = 0; i < 6; ++i) {
        const Placement placement = place(surface, {i * 37.0, i * 71.0, i * 113.0}, {});
        count += cut_columns(depth_map(surface, placement, space_of(columns), kReach));
    }
    return count;
}

int run(std::string_view name) {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const Mesh mesh = bench::refined(*sample("figurine"));
    std::size_t result = 0;
    if (name == "read-stl" || name == "read-obj") {
        const bool stl = name == "read-stl";
        const FileBytes file = stl ? write_stl(mesh.vertices, mesh.triangles, "figurine")
                                   : write_obj(mesh.vertices, mesh.triangles);
        measured([&] { result = read_mesh(file, stl ? "a.stl" : "a.obj")->triangles.size(); });
    } else if (name == "prepare") {
        measured([&] { result = prepare_surface(mesh).body.clusters.size(); });
    } else if (name == "plain") {
        const Placement placement = place(mesh, {10, 20, 30}, {});
        measured([&] { result = cut_columns(depth_map(mesh, placement, space_of(30), kReach)); });
    } else {
        const PreparedSurface surface = prepare_surface(mesh);
        const int columns = name == "columns-10"    ? 10
                            : name == "columns-30"  ? 30
                            : name == "columns-300" ? 300
                                                    : 0;
        if (columns == 0) return 1;
        measured([&] { result = placements(surface, columns); });
    }
    std::printf("%zu\n", result);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return argc == 2 ? run(argv[1]) : 1;
}
