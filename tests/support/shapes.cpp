#include "tests/support/shapes.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace snug::test {

void append(Mesh& mesh, const Mesh& other) {
    const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const Triangle& t : other.triangles)
        mesh.triangles.push_back({base + t[0], base + t[1], base + t[2]});
}

Mesh box_mesh(Vec3d min, Vec3d max) {
    Mesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        mesh.vertices.push_back(vec_cast<float>(
            Vec3d{corner & 1 ? max.x : min.x, corner & 2 ? max.y : min.y, corner & 4 ? max.z : min.z}));
    }
    mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    return mesh;
}

Mesh ringed_mesh(int rings, int around, bool rings_close, const std::function<Vec3d(int, int)>& position) {
    Mesh mesh;
    for (int ring = 0; ring < rings; ++ring) {
        for (int step = 0; step < around; ++step)
            mesh.vertices.push_back(vec_cast<float>(position(ring, step)));
    }
    const auto at = [&](int ring, int step) {
        return static_cast<std::uint32_t>(ring % rings * around + step % around);
    };
    for (int ring = 0; ring < (rings_close ? rings : rings - 1); ++ring) {
        for (int step = 0; step < around; ++step) {
            mesh.triangles.push_back({at(ring, step), at(ring + 1, step), at(ring, step + 1)});
            mesh.triangles.push_back({at(ring, step + 1), at(ring + 1, step), at(ring + 1, step + 1)});
        }
    }
    return mesh;
}

Mesh sphere_mesh(double radius, int rings) {
    return ringed_mesh(rings + 1, 2 * rings, false, [=](int ring, int step) {
        const double latitude = std::numbers::pi * ring / rings, longitude = std::numbers::pi * step / rings;
        const double s = ring == 0 || ring == rings ? 0 : std::sin(latitude);
        return Vec3d{s * std::cos(longitude), s * std::sin(longitude), std::cos(latitude)} * radius;
    });
}

Mesh torus_mesh(double large, double small) {
    return ringed_mesh(200, 100, true, [=](int ring, int step) {
        const double a = 2 * std::numbers::pi * ring / 200, b = 2 * std::numbers::pi * step / 100;
        const double r = large + small * std::cos(b);
        return Vec3d{r * std::cos(a), r * std::sin(a), small * std::sin(b)};
    });
}

Mesh inside_out(Mesh mesh) {
    for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
    return mesh;
}

double enclosed_volume(const Mesh& mesh) {
    double sum = 0;
    for (const Triangle& t : mesh.triangles) {
        const auto at = [&](int i) {
            return vec_cast<double>(mesh.vertices[t[static_cast<std::size_t>(i)]]);
        };
        sum += dot(at(0), cross(at(1), at(2))) / 6;
    }
    return sum;
}

}  // namespace snug::test
