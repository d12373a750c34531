#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <tbb/global_control.h>
#include <thread>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "snug/design/design.h"
#include "snug/fabricate/mesh_files.h"
#include "snug/foam/prepared_surface.h"
#include "snug/mesh/read.h"
#include "snug/pipeline.h"

#include "bench/contest.h"
#include "bench/measure_times.h"
#include "bench/objects.h"
#include "bench/paper_method.h"

// From a placement to two foams: the paper's method, a plain exact loop over all triangles, and Snug, by
// turns in one run over the same random rotations. Prints JSON, which report.py makes into
// docs/benchmarks.md. Usage: method_times FOLDER (where the largest object is left for other programs)

namespace snug::bench {
namespace {

using nlohmann::json;

constexpr int kRepetitions = 5;
constexpr int kFewRotations = 4;  ///< of the slow method, where no claim rests on it
constexpr int kTexels = 1024, kFewTexels = 256;

/// Tells how much of one processor the main thread was given while it had work: on a machine that others use,
/// too, times say little.
class ProcessorShare {
  public:
    template <class Work>
    void during(Work&& work) {
        const double start = processor_ms();
        wall_ += time_of(work);
        processor_ += processor_ms() - start;
    }
    [[nodiscard]] double share() const { return processor_ / wall_; }

  private:
    static double processor_ms() {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
    }
    double wall_ = 0, processor_ = 0;
};

/// Bytes of what a prepared surface keeps.
std::size_t bytes_of(const SurfaceClusters& clusters) {
    std::size_t bytes = clusters.coordinates.size() * sizeof(float) + clusters.corners.size() * 3 +
                        clusters.clusters.size() * sizeof(SurfaceClusters::Cluster) +
                        clusters.samples.size() * sizeof(Vec3f);
    for (const BoxLevel& level : clusters.levels) bytes += level.groups.size() * sizeof(BoxGroup);
    return bytes;
}

/// Reading, beside preparing on one thread and on all.
json loading(const Mesh& mesh, PreparedSurface& prepared, ProcessorShare& share) {
    const FileBytes file = write_ply(mesh.vertices, mesh.triangles, {});
    std::vector<double> reading, preparing, preparing_alone;
    for (int i = 0; i < kRepetitions; ++i) {
        reading.push_back(time_of([&] { (void)read_mesh(file, "a.ply"); }));
        preparing.push_back(time_of([&] { prepared = prepare_surface(mesh); }));
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        share.during([&] { preparing_alone.push_back(time_of([&] { prepared = prepare_surface(mesh); })); });
    }
    return {{"read", summary(reading)},
            {"prepare", summary(preparing)},
            {"prepare_one_thread", summary(preparing_alone)},
            {"mesh_bytes", 12 * (mesh.vertices.size() + mesh.triangles.size())},
            {"prepared_bytes", bytes_of(prepared.body) + bytes_of(prepared.caps)}};
}

/// `claimed`: one of the two objects that the claims are about.
json contests(const NamedMesh& object, bool claimed, ProcessorShare& share) {
    PreparedSurface prepared;
    json result{{"name", object.name},
                {"vertices", object.mesh.vertices.size()},
                {"triangles", object.mesh.triangles.size()},
                {"loading", loading(object.mesh, prepared, share)},
                {"runs", json::array()}};
    {
        PaperMethod paper(object.mesh, kTexels);
        const Contest contest{object.mesh, prepared, &paper};
        for (const int resolution : {10, 15, 20, 25, 30, 100, 300}) {
            const bool of_claim = resolution == 10 || resolution == 30 || resolution == 300;
            if (resolution > 30 && !claimed) continue;
            share.during([&] {
                result["runs"].push_back(contest.run(space_of(resolution, resolution),
                                                     of_claim || !claimed ? kRotations : kFewRotations));
            });
        }
        result["renderer"] = paper.renderer();
    }
    if (claimed) {
        PaperMethod paper(object.mesh, kFewTexels);
        result["few_texels"] = Contest{object.mesh, prepared, &paper}.run(space_of(30, 30), kFewRotations);
    }
    return result;
}

/// The growth with nx alone.
json by_layers(const Mesh& mesh) {
    const PreparedSurface prepared = prepare_surface(mesh);
    json runs = json::array();
    for (const int layers : {10, 30, 100, 1000, 4096})
        runs.push_back(Contest{mesh, prepared, nullptr}.run(space_of(30, layers), 0));
    return runs;
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
        prepare_for_many(object);
        std::vector<double> times;
        for (const Vec3d& rotation : rotations(kRotations)) {
            design.placement.rotation_deg = rotation;
            times.push_back(time_of([&] { (void)pack(object, design); }));
        }
        result.push_back({{"columns", columns}, {"time", summary(times)}});
    }
    return result;
}

void leave(const Mesh& mesh, const std::string& path) {
    const FileBytes ply = write_ply(mesh.vertices, mesh.triangles, {});
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(ply.data()), static_cast<std::streamsize>(ply.size()));
}

int run(const std::string& folder) {
    json report{{"threads", std::thread::hardware_concurrency()},
                {"compiler", __VERSION__},
                {"few_texels", kFewTexels},
                {"texels", kTexels},
                {"objects", json::array()}};
    ProcessorShare share;
    const std::vector<NamedMesh> all = objects();
    for (const NamedMesh& object : all) {
        fmt::print(stderr, "{}: {} vertices\n", object.name, object.mesh.vertices.size());
        report["objects"].push_back(contests(object, &object >= &all.back() - 1, share));
    }
    const Mesh& largest = all.back().mesh;
    report["layers"] = by_layers(largest);
    report["pack"] = packs(largest);
    report["processor_share"] = share.share();
    leave(largest, folder + "/largest.ply");
    report["rotations"] = json::array();
    for (const Vec3d& rotation : rotations(kRotations))
        report["rotations"].push_back({rotation.x, rotation.y, rotation.z});
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
