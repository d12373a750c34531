#include "snug/mesh/simple_solid.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "snug/base/rotation.h"
#include "snug/mesh/loft.h"
#include "snug/mesh/welder.h"

namespace snug {
namespace {

constexpr double kChord = 0.02;  // mm, between a chord and its curve
constexpr int kMostChords = 512, kMostOfBall = 128;

/// How many chords a circle of this radius takes, in fours.
int chords_of(double radius, int most) {
    int chords = 16;
    while (chords < most && radius * (1 - sine_cosine_degrees(180.0 / chords).cosine) > kChord) chords += 4;
    return chords;
}

Ring circle(double radius, double height, int chords) {
    Ring ring;
    for (int i = 0; i < chords; ++i) {
        const SineCosine at = sine_cosine_degrees(360.0 * i / chords);
        ring.push_back({radius * at.cosine, radius * at.sine, height});
    }
    return ring;
}

/// A rectangle about the middle whose corners are quarter circles of `steps` chords; 0: sharp.
Ring rounded_rectangle_at(Vec3d half, double radius, double height, int steps) {
    Ring ring;
    for (int corner = 0; corner < 4; ++corner) {
        const double x = corner == 0 || corner == 3 ? 1 : -1, y = corner < 2 ? 1 : -1;
        for (int step = 0; step <= steps; ++step) {
            const SineCosine at =
                sine_cosine_degrees(90.0 * corner + (steps > 0 ? 90.0 * step / steps : 0.0));
            ring.push_back({x * half.x + radius * at.cosine, y * half.y + radius * at.sine, height});
        }
    }
    return ring;
}

/// A box whose edges and corners are rounded; with half its sides as the radius, a ball.
std::vector<Ring> rounded_box(Vec3d size, double radius) {
    const int steps = radius > 0 ? chords_of(radius, kMostOfBall) / 4 : 0;
    const Vec3d half = size * 0.5 - Vec3d{radius, radius, radius};
    std::vector<Ring> rings;
    for (int i = 0; i <= 2 * steps + 1; ++i) {
        const bool lower = i <= steps;
        const int at = lower ? i : 2 * steps + 1 - i;
        const SineCosine turn = sine_cosine_degrees(steps > 0 ? 90.0 * at / steps : 0.0);
        const double height = half.z + radius * turn.cosine;
        rings.push_back(rounded_rectangle_at(half, radius * turn.sine, lower ? -height : height, steps));
    }
    return rings;
}

std::vector<Ring> rings_of(const SimpleSolid& solid) {
    const Vec3d size = solid.size_mm;
    if (solid.kind == SolidKind::box) return rounded_box(size, solid.radius_mm);
    if (solid.kind == SolidKind::ball) return rounded_box(size, size.x / 2);
    const double top = solid.kind == SolidKind::cone ? solid.top_mm : size.x;
    const int chords = chords_of(std::max(size.x, top) / 2, kMostChords);
    return {circle(size.x / 2, -size.z / 2, chords), circle(top / 2, size.z / 2, chords)};
}

/// Along which axis z comes to lie; the others follow in their order, so that nothing is mirrored.
Vec3d laid(Vec3d p, char along) {
    if (along == 'x') return {p.z, p.x, p.y};
    if (along == 'y') return {p.y, p.z, p.x};
    return p;
}

/// Without the triangles that have no area, their corners one, and with every place once.
void append_welded(const Mesh& solid, Mesh& mesh) {
    RawMeshOf<float> welded;
    Welder<float> welder(welded, solid.triangles.size());
    for (const Triangle& t : solid.triangles) {
        const std::array<std::array<Vec3f, 3>, 1> one{
            {{solid.vertices[t[0]], solid.vertices[t[1]], solid.vertices[t[2]]}}};
        if (one[0][0] == one[0][1] || one[0][1] == one[0][2] || one[0][2] == one[0][0]) continue;
        welder.append(one);
    }
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), welded.vertices.begin(), welded.vertices.end());
    for (const Triangle& t : welded.triangles)
        mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

}  // namespace

void add_solid(Mesh& mesh, const SimpleSolid& solid) {
    const Rotation turn = rotation_from_euler(solid.turn_deg);
    std::vector<Ring> rings = rings_of(solid);
    for (Ring& ring : rings)
        for (Vec3d& p : ring) p = turn(laid(p, solid.along)) + solid.centre_mm;
    Mesh alone;
    add_loft(alone, rings);
    append_welded(alone, mesh);
}

}  // namespace snug
