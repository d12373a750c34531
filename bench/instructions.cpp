#include <cstdio>
#include <tbb/global_control.h>
#include <valgrind/callgrind.h>

#include "snug/fabricate/mesh_files.h"
#include "snug/foam/block_map.h"
#include "snug/foam/depth_map.h"
#include "snug/foam/prepared_surface.h"
#include "snug/mesh/read.h"
#include "snug/mesh/samples.h"

#include "bench/refine.h"

// Fixed work on what Snug generates, for callgrind: the instructions of each case are dumped under its name,
// what makes the case ready runs uncounted and fast. See tests/instruction_counts.py, which runs it with
// --instr-atstart=no.

namespace {

using namespace snug;

const Reach kReach = reach(0, false);

template <class Work>
void counted(const char* name, const Work& work) {
    CALLGRIND_START_INSTRUMENTATION;
    const std::size_t result = work();
    CALLGRIND_STOP_INSTRUMENTATION;
    CALLGRIND_DUMP_STATS_AT(name);
    std::printf("%s: %zu\n", name, result);  // keeps the compiler from leaving the work out
}

DesignSpace space_of(int columns) {
    const double side = 290;
    return {{30, columns, columns}, {side / 30, side / columns, side / columns}};
}

std::size_t cut_columns(const DepthMap& depths) {
    std::size_t count = 0;
    for (const DepthRange& depth : depths) count += !depth.none();
    return count;
}

std::size_t placements(const PreparedSurface& surface, int columns, int count) {
    std::size_t result = 0;
    for (int i = 0; i < count; ++i) {
        const Placement placement = place(surface, {i * 37.0, i * 71.0, i * 113.0}, {});
        result += cut_columns(depth_map(surface, placement, space_of(columns), kReach));
    }
    return result;
}

}  // namespace

int main() {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const Mesh mesh = bench::refined(*sample("figurine"));
    const PreparedSurface surface = prepare_surface(mesh);
    const FileBytes stl = write_stl(mesh.vertices, mesh.triangles, "figurine");
    const FileBytes obj = write_obj(mesh.vertices, mesh.triangles);

    counted("prepare", [&] { return prepare_surface(mesh).body.clusters.size(); });
    counted("plain", [&] {
        return cut_columns(depth_map(mesh, place(mesh, {10, 20, 30}, {}), space_of(30), kReach));
    });
    counted("columns-10", [&] { return placements(surface, 10, 6); });
    counted("columns-30", [&] { return placements(surface, 30, 6); });
    counted("columns-300", [&] { return placements(surface, 300, 2); });
    counted("read-stl", [&] { return read_mesh(stl, "a.stl")->triangles.size(); });
    counted("read-obj", [&] { return read_mesh(obj, "a.obj")->triangles.size(); });
    return 0;
}
