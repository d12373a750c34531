#include "snug/base/rotation.h"

#include <cmath>

namespace snug {
namespace {

constexpr double kRadiansPerDegree = 0.017453292519943295769;

// Taylor series: below 45 degrees the first term left out is under 1e-18.
SineCosine sine_cosine_below_45_degrees(double degrees) {
    const double x = degrees * kRadiansPerDegree;
    const double q = x * x;
    double sine = 1;
    for (int n = 18; n >= 2; n -= 2) sine = 1 - q * sine / (n * (n + 1.0));
    double cosine = 1;
    for (int n = 17; n >= 1; n -= 2) cosine = 1 - q * cosine / (n * (n + 1.0));
    return {x * sine, cosine};
}

Rotation multiply(const Rotation& a, const Rotation& b) {
    Rotation product;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            double sum = 0;
            for (int m = 0; m < 3; ++m) sum += a.row[i][m] * b.row[m][k];
            product.row[i][k] = sum;
        }
    return product;
}

}  // namespace

SineCosine sine_cosine_degrees(double degrees) {
    const double turn = std::fmod(degrees, 360.0);  // exact by IEEE 754
    const double quarter = std::floor(turn / 90.0 + 0.5);
    const auto [s, c] = sine_cosine_below_45_degrees(turn - 90.0 * quarter);
    switch ((static_cast<int>(quarter) % 4 + 4) % 4) {
        case 0:
            return {s, c};
        case 1:
            return {c, -s};
        case 2:
            return {-s, -c};
        default:
            return {-c, s};
    }
}

Rotation rotation_from_euler(Vec3d angles) {
    const auto x = sine_cosine_degrees(angles.x);
    const auto y = sine_cosine_degrees(angles.y);
    const auto z = sine_cosine_degrees(angles.z);
    const Rotation rx{{Vec3d{1, 0, 0}, Vec3d{0, x.cosine, -x.sine}, Vec3d{0, x.sine, x.cosine}}};
    const Rotation ry{{Vec3d{y.cosine, 0, y.sine}, Vec3d{0, 1, 0}, Vec3d{-y.sine, 0, y.cosine}}};
    const Rotation rz{{Vec3d{z.cosine, -z.sine, 0}, Vec3d{z.sine, z.cosine, 0}, Vec3d{0, 0, 1}}};
    return multiply(rz, multiply(ry, rx));
}

}  // namespace snug
