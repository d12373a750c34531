#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "snug/base/vec.h"
#include "snug/base/vec2.h"
#include "snug/polygon/plan_region.h"

namespace snug {

/// Letters sunk into a flat top of a printed part. Rows (y) and positions (z) in steps of the part's own
/// block lines, see FaceOpening.
struct SunkLetters {
    int level = 0;       ///< of the top, in blocks from the part's floor
    PlanBox box;         ///< the rectangle that is left open there, strictly inside the top
    PlanRegion letters;  ///< strictly inside the box, meeting itself in no mere point
    double depth_mm = 0;
};

/// What a pen of this width covers that follows open lines (x along z, y along y; mm), in squares of a third
/// of the pen; squares that would meet in a mere corner have a third one beside them.
[[nodiscard]] PlanRegion inked(std::span<const std::vector<Vec2d>> lines, double pen_mm);

/// The least box with so much around the region on every side, in steps.
[[nodiscard]] PlanBox box_around(const PlanRegion& region, int steps);

/// Where the vertices of sunk letters stand: in steps and, below the top, whether at the letters' floor.
struct SunkPoint {
    PlanPoint at;
    bool floor = false;
};

/// The face around the letters, their floors and walls. The box's four corners are the vertices from
/// `box_vertex` on (in the order of FaceOpening), `points` become those from `first_vertex` on.
struct SunkFaces {
    std::vector<SunkPoint> points;
    std::vector<Triangle> triangles;  ///< outward where x counts the levels
};
[[nodiscard]] SunkFaces sunk_faces(const SunkLetters& letters, std::uint32_t box_vertex,
                                   std::uint32_t first_vertex);

}  // namespace snug
