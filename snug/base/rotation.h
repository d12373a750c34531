#pragma once

#include <array>

#include "snug/base/vec.h"

namespace snug {

/// Sine and cosine of an angle in degrees, the same bits on every system: no libm is used.
/// Multiples of 90 degrees are exact. Any finite angle is allowed.
struct SineCosine {
    double sine = 0;
    double cosine = 1;
};
[[nodiscard]] SineCosine sine_cosine_degrees(double degrees);

/// A rotation matrix, rows first.
struct Rotation {
    std::array<Vec3d, 3> row{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};

    [[nodiscard]] Vec3d operator()(Vec3d p) const { return {dot(row[0], p), dot(row[1], p), dot(row[2], p)}; }
};

/// The rotation by Euler angles psi, theta, phi (degrees) about the fixed axes x, then y, then z:
/// R = Rz(phi) Ry(theta) Rx(psi).
[[nodiscard]] Rotation rotation_from_euler(Vec3d psi_theta_phi_degrees);

}  // namespace snug
