#include "snug/fabricate/printing/bores.h"

#include <array>

#include "snug/base/rotation.h"

namespace snug {

double bore_corner_radius_mm(const PrintOptions& options) {
    return (options.dowel_diameter_mm / 2 + options.joint_clearance_mm) /
           sine_cosine_degrees(180.0 / kBoreSides).cosine;
}

double bore_depth_mm(const PrintOptions& options) {
    return options.dowel_length_mm / 2 + options.joint_clearance_mm;
}

double bore_volume_mm3(const PrintOptions& options) {
    const double radius = bore_corner_radius_mm(options);
    return kBoreSides / 2.0 * radius * radius * sine_cosine_degrees(360.0 / kBoreSides).sine *
           bore_depth_mm(options);
}

std::vector<Vec3d> bore_ring(int axis, Vec3d centre, double radius) {
    const PlaneAxes axes = plane_axes(axis);
    std::vector<Vec3d> ring(kBoreSides, centre);
    for (int i = 0; i < kBoreSides; ++i) {
        const SineCosine turn = sine_cosine_degrees(360.0 / kBoreSides * i);
        Vec3d& at = ring[static_cast<std::size_t>(i)];
        at[axes.row] += radius * turn.cosine;
        at[axes.position] += radius * turn.sine;
    }
    return ring;
}

void add_bore(const BoreVertices& at, int axis, bool after, std::vector<Triangle>& triangles) {
    // Whether the face turns from its rows towards its positions.
    const bool forward = axis == 2 ? after : !after;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        triangles.push_back(forward ? Triangle{a, b, c} : Triangle{a, c, b});
    };
    const auto next = [](std::uint32_t i) { return (i + 1) % kBoreSides; };
    // The corner of the opening in each quadrant, from rows towards positions.
    constexpr std::array<std::uint32_t, 4> kCorner{3, 1, 0, 2};
    for (std::uint32_t i = 0; i < kBoreSides; ++i) {
        const std::uint32_t quadrant = i / (kBoreSides / 4);
        add(at.mouth + next(i), at.mouth + i, at.opening + kCorner[quadrant]);
        if (next(i) % (kBoreSides / 4) == 0)
            add(at.opening + kCorner[quadrant], at.opening + kCorner[(quadrant + 1) % 4], at.mouth + next(i));
        add(at.mouth + i, at.mouth + next(i), at.end + next(i));
        add(at.mouth + i, at.end + next(i), at.end + i);
        if (i >= 2) add(at.end, at.end + i - 1, at.end + i);
    }
}

}  // namespace snug
