#include <algorithm>
#include <cmath>

#include "snug/mesh/surface_nets.h"
#include "snug/samples/sample_solids.h"

// After the goggle-eyed dogu of Japan's late Jomon period. Distances to simple solids, merged smoothly as
// after Inigo Quilez, "Distance functions" and "Smooth minimum".

namespace snug {
namespace {

// The figure as it stands: x to its front, y to its left, z upward. It is symmetric: parts with y > 0 stand
// for both sides.

/// About the distance to an ellipsoid.
double ellipsoid(Vec3d p, Vec3d middle, Vec3d radii) {
    p = p - middle;
    const Vec3d once{p.x / radii.x, p.y / radii.y, p.z / radii.z};
    const double near = length(once);
    const double steepness = length({once.x / radii.x, once.y / radii.y, once.z / radii.z});
    return steepness > 0 ? near * (near - 1) / steepness : -std::min({radii.x, radii.y, radii.z});
}

/// A rod with round ends, thicker at one than at the other.
double limb(Vec3d p, Vec3d from, Vec3d to, double radius_from, double radius_to) {
    const Vec3d along = to - from;
    const double t = std::clamp(dot(p - from, along) / dot(along, along), 0.0, 1.0);
    return length(p - from - along * t) - (radius_from + (radius_to - radius_from) * t);
}

/// A band around something upright that is elliptic from above.
double band(Vec3d p, Vec3d middle, double radius_x, double radius_y, double thickness_radius) {
    p = p - middle;
    const double around = ellipsoid({p.x, p.y, 0}, {}, {radius_x, radius_y, 1e9});
    return std::sqrt(around * around + p.z * p.z) - thickness_radius;
}

/// The union, rounded where the two meet within `width`.
double merged(double a, double b, double width) {
    const double h = std::max(width - std::fabs(a - b), 0.0) / width;
    return std::min(a, b) - h * h * width / 4;
}

/// `a` without `b`, rounded in the same way.
double carved(double a, double b, double width) {
    return -merged(-a, b, width);
}

double trunk(Vec3d p) {
    double solid = ellipsoid(p, {0, 0, 12}, {24, 38, 30});
    solid = merged(solid, limb(p, {-2, 0, 29}, {-2, 44, 27}, 15, 14), 14);  // shoulders
    solid = merged(solid, limb(p, {0, 0, 8}, {0, 0, -20}, 22, 23), 16);     // waist
    solid = merged(solid, ellipsoid(p, {-2, 0, -40}, {27, 45, 24}), 16);    // hips
    return merged(solid, limb(p, {0, 0, 30}, {0, 0, 56}, 17, 16), 10);      // neck
}

double limbs(Vec3d p) {
    double solid = limb(p, {-2, 44, 27}, {-4, 69, -7}, 14, 11.5);              // upper arm
    solid = merged(solid, limb(p, {-4, 69, -7}, {8, 44, -33}, 11.5, 9.5), 7);  // forearm, the hand on the hip
    solid = merged(solid, ellipsoid(p, {10, 43, -35}, {9, 12, 9}), 6);
    const double leg = limb(p, {0, 25, -48}, {0, 29, -94}, 22, 17.5);
    return std::min(solid, merged(leg, ellipsoid(p, {6, 30, -108}, {25, 20, 12}), 9));
}

double head(Vec3d p) {
    double solid = ellipsoid(p, {0, 0, 82}, {29, 45, 31});
    solid = merged(solid, ellipsoid(p, {2, 0, 66}, {24, 36, 22}), 10);   // cheeks and chin
    solid = merged(solid, ellipsoid(p, {-3, 0, 107}, {19, 27, 12}), 8);  // hair, in two tiers
    solid = merged(solid, ellipsoid(p, {-4, 0, 118}, {11, 16, 9}), 5);
    return merged(solid, ellipsoid(p, {-2, 45, 80}, {8, 8, 14}), 6);  // ears
}

/// What is laid on: eyes, nose, mouth, necklace, belt, buttons, anklets.
double with_ornaments(double solid, Vec3d p) {
    solid = merged(solid, ellipsoid(p, {24.5, 20.5, 84}, {11, 18, 15}), 4);
    solid = merged(solid, limb(p, {29, 0, 78}, {31, 0, 69}, 3.5, 5), 4);
    solid = merged(solid, ellipsoid(p, {24.5, 0, 57}, {7, 10.5, 6.5}), 4);
    solid = merged(solid, band(p, {0, 0, 42}, 20, 22, 5), 4);
    solid = merged(solid, band(p, {-0.5, 0, -19}, 25, 28, 5), 4);
    for (const double z : {20.0, 3.0}) solid = merged(solid, ellipsoid(p, {23.5, 0, z}, {6, 6, 6}), 4);
    solid = merged(solid, ellipsoid(p, {20, 20, 22}, {8, 9, 9}), 5);
    return merged(solid, band(p, {0, 28.2, -84}, 20, 20, 5), 4);
}

/// What is cut in: the slits of the goggle eyes, the mouth, a navel.
double with_carvings(double solid, Vec3d p) {
    solid = carved(solid, ellipsoid(p, {37.5, 20.5, 84}, {6.5, 15.5, 3.8}), 3);
    solid = carved(solid, ellipsoid(p, {33, 0, 57}, {6, 6, 3.4}), 3);
    return carved(solid, ellipsoid(p, {29, 0, -38}, {6, 6, 6}), 3);
}

double figurine(Vec3d p) {
    p.y = std::fabs(p.y);
    double solid = merged(trunk(p), limbs(p), 7);
    solid = merged(solid, head(p), 5);
    return with_carvings(with_ornaments(solid, p), p);
}

}  // namespace

Mesh figurine_sample() {
    Mesh mesh = surface_nets(figurine, {{-40, -88, -128}, {50, 88, 134}}, 2.4);
    centre(mesh);
    return mesh;
}

}  // namespace snug
