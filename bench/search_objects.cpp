#include "bench/search_objects.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <utility>

#include "snug/formats/read.h"
#include "snug/samples/samples.h"

#include "bench/refine.h"

namespace snug::bench {
namespace {

constexpr std::size_t kMostTriangles = 100000;

NamedMesh ready(std::string name, Mesh mesh) {
    while (4 * mesh.triangles.size() <= kMostTriangles) mesh = refined(mesh);
    const Vec3d size = bounds(mesh).size();
    mesh = scaled(std::move(mesh), kDiagonal / std::sqrt(dot(size, size)));
    return {std::move(name), std::move(mesh)};
}

}  // namespace

std::vector<NamedMesh> search_objects() {
    std::vector<NamedMesh> objects;
    const char* models = std::getenv("SNUG_MODELS");
    const std::filesystem::path folder = models ? models : SNUG_SOURCE_DIR "/../shared/models";
    std::vector<std::filesystem::path> files;
    if (std::filesystem::is_directory(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const auto& path : files) {
        std::ifstream file(path, std::ios::binary);
        const std::string text((std::istreambuf_iterator<char>(file)), {});
        auto mesh = read_mesh(std::as_bytes(std::span(text)), path.string());
        if (mesh) objects.push_back(ready(path.stem().string(), std::move(*mesh)));
    }
    for (const std::string_view name : sample_names())
        objects.push_back(ready(std::string(name), *sample(name)));
    return objects;
}

}  // namespace snug::bench
