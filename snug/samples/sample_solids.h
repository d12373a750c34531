#pragma once

#include <span>
#include <vector>

#include "snug/mesh/loft.h"
#include "snug/mesh/mesh.h"

// What the samples are made of: closed, outward solids, in millimetres.

namespace snug {

/// A point in a plane.
struct Point2 {
    double a = 0, b = 0;
};

/// Where a flat thing lies in space: its plane is spanned by `a` and `b`, it grows along `up` = a x b.
struct Frame {
    Vec3d origin;
    Vec3d a, b, up;

    [[nodiscard]] Vec3d operator()(Point2 p, double height) const {
        return origin + a * p.a + b * p.b + up * height;
    }
};

using Outline = std::vector<Point2>;  ///< counter-clockwise

/// About the middle.
[[nodiscard]] Outline rounded_rectangle(double width, double height, double corner_radius);

/// A plate or block over a rounded rectangle, its edges at both ends rounded, too.
struct Block {
    double width = 0, height = 0;  ///< along the frame's a and b
    double corner_radius = 0;
    double low = 0, high = 0;  ///< along the frame's up
    double edge_radius = 0;    ///< at most half of high - low
};
void add_block(Mesh& mesh, const Frame& frame, const Block& block);

/// A corner of the outline of something turned on a lathe about the frame's `up`.
struct ProfilePoint {
    double height = 0, radius = 0;  ///< radius > 0: the ends are closed by discs
    bool ribbed = false;
};
/// Grooves along the axis around the ribbed corners; `count` must divide half the number of sides.
struct Ribs {
    int count = 0;
    double depth = 0;
};
/// Appends it; the profile runs so that the solid lies on its right (height drawn to the right, radius
/// upward): from the lower end to the upper for the outside, and back down for an inside.
void add_turned(Mesh& mesh, const Frame& frame, std::span<const ProfilePoint> profile, int sides,
                Ribs ribs = {});

/// Appends a ring (torus) about the frame's `up`.
void add_ring(Mesh& mesh, const Frame& frame, double radius, double thickness_radius, int around, int across);

/// A smooth curve through points (Catmull-Rom): `steps` points for each span between two of them.
[[nodiscard]] std::vector<Point2> smooth_curve(std::span<const Point2> points, int steps);

/// Moves the middle of the bounding box to the origin.
void centre(Mesh& mesh);

// The samples, one a file.
[[nodiscard]] Mesh vase_sample();
[[nodiscard]] Mesh camera_sample();
[[nodiscard]] Mesh figurine_sample();

}  // namespace snug
