#include "bench/objects.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "snug/formats/read.h"
#include "snug/samples/samples.h"

#include "bench/refine.h"
#include "bench/shared_folder.h"
#include "tests/support/random.h"

namespace snug::bench {
namespace {

constexpr double kNoise = 0.05;  // mm at kDiagonal
constexpr std::uint64_t kSeed = 2503;

struct Source {
    const char* file;
    const char* instead;  ///< a sample
    int refinements;
};

NamedMesh made(const Source& source) {
    NamedMesh object;
    auto mesh = shared_model(source.file);
    object.name =
        mesh ? std::string(source.file).substr(0, std::string(source.file).find('.')) : source.instead;
    object.mesh = mesh ? std::move(*mesh) : *sample(source.instead);
    for (int i = 0; i < source.refinements; ++i) object.mesh = refined(object.mesh);
    const Vec3d size = bounds(object.mesh).size();
    object.mesh = scaled(std::move(object.mesh), kDiagonal / std::sqrt(dot(size, size)));
    test::Random random(kSeed);
    for (Vec3f& vertex : object.mesh.vertices)
        for (int axis = 0; axis < 3; ++axis)
            vertex[axis] += static_cast<float>(random.between(-kNoise, kNoise));
    return object;
}

}  // namespace

std::optional<Mesh> shared_model(const std::string& file_name) {
    std::ifstream file(shared_folder("SNUG_MODELS", "models") / file_name, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    if (text.empty()) return {};
    auto mesh = read_mesh(std::as_bytes(std::span(text)), file_name);
    if (!mesh) return {};
    return std::move(*mesh);
}

std::vector<NamedMesh> objects() {
    const Source sources[] = {{"cow.obj", "vase", 0},
                              {"camelhead.off", "camera", 0},
                              {"stanford-bunny.obj", "figurine", 0},
                              {"armadillo.obj", "figurine", 1},
                              {"stanford-bunny.obj", "torus", 2},
                              {"armadillo.obj", "figurine", 2}};
    std::vector<NamedMesh> result;
    for (const Source& source : sources) result.push_back(made(source));
    return result;
}

std::vector<Vec3d> rotations(int count) {
    test::Random random(kSeed);
    std::vector<Vec3d> result;
    const auto angle = [&] { return random.between(-180, 180); };
    for (int i = 0; i < count; ++i) {
        const double psi = angle(), theta = angle(), phi = angle();
        result.push_back({psi, theta, phi});
    }
    return result;
}

}  // namespace snug::bench
