#pragma once

#include "snug/design/zone.h"
#include "snug/object/object.h"

#include "tests/support/random.h"

namespace snug::test {

/// A point of a random triangle of a mesh.
[[nodiscard]] inline Vec3d point_of(Random& random, const Mesh& mesh) {
    const Triangle& t = mesh.triangles[static_cast<std::size_t>(
        random.integer(0, static_cast<int>(mesh.triangles.size()) - 1))];
    double a = random.between(0, 1), b = random.between(0, 1);
    if (a + b > 1) a = 1 - a, b = 1 - b;
    const auto corner = [&](std::size_t i) { return vec_cast<double>(mesh.vertices[t[i]]); };
    return corner(0) + (corner(1) - corner(0)) * a + (corner(2) - corner(0)) * b;
}

/// A few balls around points of the surface.
[[nodiscard]] inline Zone random_zone(Random& random, const Object& object) {
    Zone zone;
    for (int i = random.integer(1, 4); i > 0; --i)
        zone.balls.push_back({point_of(random, object.mesh) + object.mesh.origin, random.between(1, 25)});
    zone.keep_off_mm = random.between(1, 40);
    return zone;
}

}  // namespace snug::test
