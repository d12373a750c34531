#pragma once

#include <gtest/gtest.h>

#include "snug/solid/solid.h"

#include "tests/support/closedness.h"

namespace snug::test {

/// The solid of a piece is closed both ways and holds just the blocks that it keeps.
inline void expect_solid_of(const Foams& foams, Piece piece, const DesignSpace& space) {
    const Solid solid = solid_of(foams, piece, space);
    long long blocks = 0;
    for (const Run& run : foams.piece(piece)) blocks += run.blocks();
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
