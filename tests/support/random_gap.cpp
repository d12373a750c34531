#include "tests/support/random_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "snug/base/box.h"
#include "snug/mesh/triangle_tree.h"

#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace snug::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Mesh random_blob(Random& random) {
    const bool tube = random.chance(0.4);
    const int rings = random.integer(4, 7), around = random.integer(4, 8);
    const Vec3d centre{random.between(-15, 15), random.between(-15, 15), random.between(-15, 15)};
    const double large = random.between(8, 22);
    Mesh blob = ringed_mesh(rings + 1, around, tube, [&](int ring, int step) {
        const double a = (tube ? 2 : 1) * std::numbers::pi * ring / (tube ? rings + 1 : rings),
                     b = 2 * std::numbers::pi * step / around;
        const double r = large * random.between(0.6, 1.1);
        if (tube) {
            const double out = r + large * 0.4 * std::cos(b);
            return centre + Vec3d{out * std::cos(a), out * std::sin(a), large * 0.4 * std::sin(b)};
        }
        const double s = ring % rings == 0 ? 0 : std::sin(a);
        const double height = ring % rings == 0 ? large : r;
        return centre + Vec3d{r * s * std::cos(b), r * s * std::sin(b), height * std::cos(a)};
    });
    return random.chance(0.3) ? inside_out(blob) : blob;
}

}  // namespace

RandomCase random_case(std::uint64_t seed) {
    Random random(seed);
    RandomCase c;
    for (int i = random.integer(1, 3); i > 0; --i) append(c.mesh, random_blob(random));
    c.placement = place(c.mesh, {random.between(0, 360), random.between(0, 360), random.between(0, 360)},
                        {random.between(-5, 5), random.between(-5, 5), random.between(-5, 5)});
    c.space = {{8, 7, 6}, {random.between(9, 15), random.between(9, 15), random.between(9, 15)}};
    c.blocks = BlockMap(7, 6);
    for (CutRun& run : c.blocks) {
        if (random.chance(0.2)) continue;
        const int first = random.integer(0, 4);
        run = {static_cast<std::int16_t>(first), static_cast<std::int16_t>(random.integer(first + 1, 8))};
    }
    for (const Vec3f& v : c.mesh.vertices) c.placed.push_back(c.placement(v));
    return c;
}

int winding_number(const RandomCase& object, Vec3d p) {
    double angle = 0;
    for (const Triangle& t : object.mesh.triangles) {
        const Vec3d a = object.placed[t[0]] - p, b = object.placed[t[1]] - p, c = object.placed[t[2]] - p;
        const double la = length(a), lb = length(b), lc = length(c);
        angle += 2 * std::atan2(dot(a, cross(b, c)),
                                la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return static_cast<int>(std::lround(angle / (4 * std::numbers::pi)));
}

bool in_hull(const RandomCase& object, Vec3d p) {
    bool below = false, above = false;
    for (const Triangle& t : object.mesh.triangles) {
        const Vec3d a = object.placed[t[0]], b = object.placed[t[1]], c = object.placed[t[2]];
        const auto side = [&](Vec3d s, Vec3d e) {
            return (e.y - s.y) * (p.z - s.z) - (e.z - s.z) * (p.y - s.y);
        };
        const double wa = side(b, c), wb = side(c, a), wc = side(a, b);
        if (!((wa > 0 && wb > 0 && wc > 0) || (wa < 0 && wb < 0 && wc < 0))) continue;
        const double x = (wa * a.x + wb * b.x + wc * c.x) / (wa + wb + wc);
        below = below || x <= p.x;
        above = above || x >= p.x;
    }
    return below && above;
}

double distance_to_foam(const RandomCase& c, Vec3d p) {
    const Box3d all = c.space.box();
    double nearest = kInfinity;
    for (int axis = 0; axis < 3; ++axis)
        nearest = std::min({nearest, p[axis] - all.min[axis], all.max[axis] - p[axis]});
    for (int j = 0; j < c.space.blocks.y; ++j) {
        for (int k = 0; k < c.space.blocks.z; ++k) {
            for (int i = 0; i < c.space.blocks.x; ++i) {
                if (i >= c.blocks(j, k).first && i < c.blocks(j, k).end) continue;
                Vec3d d;
                const Vec3i block{i, j, k};
                for (int axis = 0; axis < 3; ++axis) {
                    d[axis] = std::max({c.space.face(axis, block[axis]) - p[axis],
                                        p[axis] - c.space.face(axis, block[axis] + 1), 0.0});
                }
                nearest = std::min(nearest, length(d));
            }
        }
    }
    return std::max(nearest, 0.0);
}

double distance_to_surface(const RandomCase& c, Vec3d p) {
    double nearest = kInfinity;
    for (const Triangle& t : c.mesh.triangles) {
        nearest = std::min(
            nearest, length(nearest_on_triangle(c.placed[t[0]], c.placed[t[1]], c.placed[t[2]], p) - p));
    }
    return nearest;
}

double room_in_gap(const RandomCase& c, Vec3d p) {
    const double foam = distance_to_foam(c, p);
    if (foam <= 0 || winding_number(c, p) != 0) return 0;
    return std::min(foam, distance_to_surface(c, p));
}

}  // namespace snug::test
