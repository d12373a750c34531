#pragma once

#include <vector>

#include <gtest/gtest.h>

#include "tests/support/closedness.h"
#include "tests/support/printed_files.h"

namespace snug::test {

inline void expect_closed(const PrintedItem& item) {
    EXPECT_TRUE(every_edge_has_two_triangles(item.triangles)) << item.name;
    EXPECT_TRUE(closed_when_welded(item.vertices, item.triangles)) << item.name;
    EXPECT_GT(signed_volume(item.vertices, item.triangles), 0) << item.name;
}

/// Each stands on the bed, within it, and almost 5 mm from the others.
inline void expect_on_bed(const std::vector<PrintedItem>& items, Vec3d bed) {
    for (const PrintedItem& item : items) {
        const Box3d box = bounds_of(item);
        EXPECT_NEAR(box.min.z, 0, 1e-6) << item.name;
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(box.min[axis], 0) << item.name;
            EXPECT_LE(box.max[axis], bed[axis] + 1e-3) << item.name;
        }
        for (const PrintedItem& other : items) {
            if (&item == &other) continue;
            const Box3d b = bounds_of(other);
            EXPECT_TRUE(box.max.x + 4.9 < b.min.x || b.max.x + 4.9 < box.min.x || box.max.y + 4.9 < b.min.y ||
                        b.max.y + 4.9 < box.min.y);
        }
    }
}

}  // namespace snug::test
