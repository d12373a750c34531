#include <algorithm>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <malloc.h>
#include <new>
#include <numbers>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "snug/formats/mesh_files.h"
#include "snug/formats/read.h"

// The readers beside assimp, on the same bytes in memory, by turns in one run; a million triangles. assimp
// may leave out whatever it can: its vertices are joined for STL only, where Snug joins them, too. Memory is
// the most that was allocated at one time while reading, in meshes of 12 bytes a vertex and 12 a triangle;
// the file's bytes do not count. Link with benchmark::benchmark and assimp::assimp, as a program of its own,
// since it counts what operator new gives out.

namespace {

bool counting = false;
std::size_t allocated = 0, most_allocated = 0;

}  // namespace

void* operator new(std::size_t size) {
    void* const place = std::malloc(size == 0 ? 1 : size);
    if (place == nullptr) std::abort();
    if (counting) {
        allocated += malloc_usable_size(place);
        most_allocated = std::max(most_allocated, allocated);
    }
    return place;
}
void operator delete(void* place) noexcept {
    // What was there before the counting began may go during it.
    if (counting && place != nullptr) allocated -= std::min(allocated, malloc_usable_size(place));
    std::free(place);
}
void operator delete(void* place, std::size_t) noexcept {
    operator delete(place);
}

namespace snug::bench {
namespace {

constexpr int kAround = 1000, kAcross = 500;  // vertices of the ring: 1,000,000 triangles
constexpr std::size_t kTriangles = 2 * kAround * kAcross;
constexpr double kNoise = 0.05;  // mm, so that numbers have as many digits as a scan's
constexpr int kRepetitions = 5;

double noise(std::uint64_t number) {
    std::uint64_t z = number * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return kNoise * (static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53 - 0.5);
}

Mesh ring() {
    Mesh mesh;
    for (int i = 0; i < kAround; ++i) {
        for (int j = 0; j < kAcross; ++j) {
            const double u = 2 * std::numbers::pi * i / kAround, v = 2 * std::numbers::pi * j / kAcross;
            const double r = 80 + 40 * std::cos(v) + noise(mesh.vertices.size());
            mesh.vertices.push_back(
                vec_cast<float>(Vec3d{r * std::cos(u), r * std::sin(u), 40 * std::sin(v)}));
        }
    }
    const auto at = [](int i, int j) {
        return static_cast<std::uint32_t>(i % kAround * kAcross + j % kAcross);
    };
    for (int i = 0; i < kAround; ++i) {
        for (int j = 0; j < kAcross; ++j) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return mesh;
}

/// The ring's triangles in no order, as files have them that were merged from many parts.
Mesh shuffled_ring() {
    Mesh mesh = ring();
    for (std::size_t t = mesh.triangles.size() - 1; t > 0; --t)
        std::swap(
            mesh.triangles[t],
            mesh.triangles[static_cast<std::size_t>((noise(t) / kNoise + 0.5) * static_cast<double>(t))]);
    return mesh;
}

/// Triangles that share no vertex: nothing to weld, the most memory.
Mesh loose_ring() {
    Mesh mesh = ring();
    std::vector<Vec3f> corners;
    for (Triangle& triangle : mesh.triangles) {
        for (std::uint32_t& v : triangle) {
            const double number = static_cast<double>(corners.size());
            corners.push_back(mesh.vertices[v] + Vec3f{static_cast<float>(noise(corners.size())), 0,
                                                       static_cast<float>(number * 1e-5)});
            v = static_cast<std::uint32_t>(corners.size() - 1);
        }
    }
    mesh.vertices = std::move(corners);
    return mesh;
}

struct Measured {
    double milliseconds = 0;
    double memory = 0;  ///< bytes
};

template <class Read>
Measured measure(const Read& read) {
    allocated = most_allocated = 0;
    counting = true;
    const auto start = std::chrono::steady_clock::now();
    read();
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    counting = false;
    return {time.count(), static_cast<double>(most_allocated)};
}

Measured by_snug(const FileBytes& file, const char* ending) {
    return measure([&] {
        const auto mesh = read_mesh(file, ending);
        if (!mesh || mesh->triangles.size() != kTriangles) std::abort();
        benchmark::DoNotOptimize(mesh->triangles.data());
    });
}

Measured by_assimp(const FileBytes& file, const char* ending, unsigned steps) {
    return measure([&] {
        Assimp::Importer importer;
        const aiScene* scene = importer.ReadFileFromMemory(file.data(), file.size(), steps, ending + 1);
        if (scene == nullptr || scene->mNumMeshes != 1 || scene->mMeshes[0]->mNumFaces != kTriangles)
            std::abort();
        benchmark::DoNotOptimize(scene->mMeshes);
    });
}

double bytes_of_mesh(const FileBytes& file, const char* ending) {
    const auto mesh = read_mesh(file, ending);
    if (!mesh) std::abort();
    return 12.0 * static_cast<double>(mesh->vertices.size() + mesh->triangles.size());
}

void beside_assimp(benchmark::State& state, const FileBytes& file, const char* ending, unsigned steps) {
    const double mesh = bytes_of_mesh(file, ending);
    for (auto unused : state) {
        const Measured snug = by_snug(file, ending);
        const Measured assimp = by_assimp(file, ending, steps);
        state.SetIterationTime(snug.milliseconds / 1000);
        state.counters["assimp_ms"] = assimp.milliseconds;
        state.counters["times_faster"] = assimp.milliseconds / snug.milliseconds;
        state.counters["memory_of_mesh"] = snug.memory / mesh;
        state.counters["assimp_memory"] = assimp.memory / mesh;
    }
}

void add(const char* name, FileBytes file, const char* ending, unsigned steps) {
    benchmark::RegisterBenchmark(name,
                                 [file = std::move(file), ending, steps](benchmark::State& state) {
                                     beside_assimp(state, file, ending, steps);
                                 })
        ->UseManualTime()
        ->Iterations(1)
        ->Repetitions(kRepetitions)
        ->ReportAggregatesOnly()
        ->Unit(benchmark::kMillisecond);
}

void add_all() {
    constexpr unsigned kWelded = aiProcess_JoinIdenticalVertices | aiProcess_Triangulate;
    const Mesh mesh = ring(), shuffled = shuffled_ring(), loose = loose_ring();
    add("stl_binary", write_stl(mesh.vertices, mesh.triangles, "ring"), ".stl", kWelded);
    add("stl_binary_shuffled", write_stl(shuffled.vertices, shuffled.triangles, "ring"), ".stl", kWelded);
    add("stl_binary_loose", write_stl(loose.vertices, loose.triangles, "ring"), ".stl", kWelded);
    add("ply_binary", write_ply(mesh.vertices, mesh.triangles, {}), ".ply", aiProcess_Triangulate);
    add("ply_binary_coloured", write_ply(mesh.vertices, mesh.triangles, kLowerBlue), ".ply",
        aiProcess_Triangulate);
    add("obj", write_obj(mesh.vertices, mesh.triangles), ".obj", aiProcess_Triangulate);
}

}  // namespace
}  // namespace snug::bench

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    snug::bench::add_all();
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
