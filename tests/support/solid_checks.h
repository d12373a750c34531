#pragma once

#include <gtest/gtest.h>

#include "snug/solid/solid.h"

#include "tests/support/closedness.h"

namespace snug::test {

/// The solid of a half with these heights is closed both ways and holds just its blocks.
inline void expect_solid_of(const Solid& solid, const Grid<std::uint16_t>& heights,
                            const DesignSpace& space) {
    long long blocks = 0;
    for (const auto height : heights) blocks += height;
    if (blocks == 0) {
        EXPECT_TRUE(solid.triangles.empty());
        return;
    }
    EXPECT_TRUE(every_edge_has_two_triangles(solid.triangles));
    EXPECT_TRUE(closed_when_welded(solid.vertices, solid.triangles));
    const double volume = static_cast<double>(blocks) * space.block_volume();
    EXPECT_NEAR(signed_volume(solid.vertices, solid.triangles), volume, volume * 1e-5);
}

}  // namespace snug::test
