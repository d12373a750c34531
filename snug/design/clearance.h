#pragma once

#include <algorithm>

#include "snug/base/box.h"
#include "snug/base/vec.h"

namespace snug {

constexpr double kGreatestLength = 1e6;  // mm: offsets, walls, clearances
constexpr double kFarthestPlace = 1e11;  // mm: coordinates of a file, those of surveys included

/// How far the object is grown before foam is cut, in mm along x, y and z on both sides, for each half of its
/// own; negative: a squeeze fit.
struct Clearance {
    Vec3d lower;
    Vec3d upper;

    /// The same everywhere; a plain number is meant so.
    constexpr Clearance(double mm = 0) : lower{mm, mm, mm}, upper{mm, mm, mm} {}
    constexpr Clearance(Vec3d lower_mm, Vec3d upper_mm) : lower(lower_mm), upper(upper_mm) {}

    [[nodiscard]] bool same_in_both() const { return lower == upper; }
    [[nodiscard]] bool is_one() const { return *this == Clearance(lower.x); }
    [[nodiscard]] double least() const {
        return std::min({lower.x, lower.y, lower.z, upper.x, upper.y, upper.z});
    }
    friend bool operator==(const Clearance&, const Clearance&) = default;
};

[[nodiscard]] inline Clearance operator+(const Clearance& clearance, double mm) {
    const Vec3d more{mm, mm, mm};
    return {clearance.lower + more, clearance.upper + more};
}

/// The room that an object of this box takes, with the clearance of both halves around it.
[[nodiscard]] inline Box3d grown(Box3d box, const Clearance& clearance) {
    box.min.x -= clearance.lower.x;
    box.max.x += clearance.upper.x;
    for (const int axis : {1, 2}) {
        const double side = std::max(clearance.lower[axis], clearance.upper[axis]);
        box.min[axis] -= side;
        box.max[axis] += side;
    }
    return box;
}

}  // namespace snug
