#pragma once

#include <array>

#include "snug/base/vec.h"

namespace snug {

/// A symmetric 3 x 3 matrix.
struct Symmetric {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

    /// Adds v times v transposed.
    void add_square(Vec3d v) {
        xx += v.x * v.x;
        xy += v.x * v.y;
        xz += v.x * v.z;
        yy += v.y * v.y;
        yz += v.y * v.z;
        zz += v.z * v.z;
    }
};

/// Principal axes: unit vectors at right angles to each other with their values, the greatest first.
struct PrincipalAxes {
    std::array<double, 3> value{};
    std::array<Vec3d, 3> axis;
};
/// By Jacobi's method; the same bits everywhere.
[[nodiscard]] PrincipalAxes principal_axes(const Symmetric& matrix);

}  // namespace snug
