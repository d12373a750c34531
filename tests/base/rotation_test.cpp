#include "snug/base/rotation.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace snug {
namespace {

TEST(Rotation, QuarterTurnsAreExact) {
    for (int quarter = -9; quarter <= 9; ++quarter) {
        const auto [sine, cosine] = sine_cosine_degrees(90.0 * quarter);
        const int turn = ((quarter % 4) + 4) % 4;
        EXPECT_EQ(sine, turn == 1 ? 1 : turn == 3 ? -1 : 0);
        EXPECT_EQ(cosine, turn == 0 ? 1 : turn == 2 ? -1 : 0);
    }
}

TEST(Rotation, SineAndCosineAgreeWithTheMathLibrary) {
    test::Random random(1);
    for (int i = 0; i < 100000; ++i) {
        const double degrees = random.between(-720, 720);
        const long double radians = static_cast<long double>(degrees) * 3.14159265358979323846264L / 180;
        const auto [sine, cosine] = sine_cosine_degrees(degrees);
        ASSERT_NEAR(sine, static_cast<double>(std::sin(radians)), 1e-15) << degrees;
        ASSERT_NEAR(cosine, static_cast<double>(std::cos(radians)), 1e-15) << degrees;
    }
}

TEST(Rotation, TurnsAboutFixedAxesXThenYThenZ) {
    const auto turned = [](Vec3d angles, Vec3d p) { return rotation_from_euler(angles)(p); };
    EXPECT_EQ(turned({90, 0, 0}, {0, 1, 0}), (Vec3d{0, 0, 1}));
    EXPECT_EQ(turned({0, 90, 0}, {0, 0, 1}), (Vec3d{1, 0, 0}));
    EXPECT_EQ(turned({0, 0, 90}, {1, 0, 0}), (Vec3d{0, 1, 0}));
    // x first takes y to z, then y takes z to x, then z takes x to y.
    EXPECT_EQ(turned({90, 90, 90}, {0, 1, 0}), (Vec3d{0, 1, 0}));
    EXPECT_EQ(turned({90, 90, 0}, {0, 1, 0}), (Vec3d{1, 0, 0}));
}

TEST(Rotation, KeepsLengthsAndHandedness) {
    test::Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const auto [x, y, z] = rotation_from_euler({random.between(-400, 400), random.between(-400, 400),
                                                    random.between(-400, 400)})
                                   .row;
        EXPECT_NEAR(dot(x, x), 1, 1e-14);
        EXPECT_NEAR(dot(x, y), 0, 1e-14);
        EXPECT_NEAR(dot(cross(x, y), z), 1, 1e-14);
    }
}

}  // namespace
}  // namespace snug
