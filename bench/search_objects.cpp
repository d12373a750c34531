#include "bench/search_objects.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <span>
#include <utility>

#include "snug/formats/read.h"
#include "snug/samples/samples.h"

#include "bench/refine.h"
#include "bench/shared_folder.h"

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
    for (const auto& path : shared_files("SNUG_MODELS", "models")) {
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
