#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/mesh/mesh.h"

// What files hold beside the object: places that are no numbers, as depth cameras and damaged exports write
// them, and faces that are none. They are left out and counted (ReadNotes), as long as most of the object is
// there.

namespace snug {

/// Beyond this a coordinate is as good as none.
constexpr double kGreatestCoordinate = 1e30;

/// Whether a place is one: three numbers, none beyond kGreatestCoordinate.
[[nodiscard]] inline bool usable(Vec3d p) {
    return std::fabs(p.x) <= kGreatestCoordinate && std::fabs(p.y) <= kGreatestCoordinate &&
           std::fabs(p.z) <= kGreatestCoordinate;
}
[[nodiscard]] inline bool usable(Vec3f p) {
    return usable(vec_cast<double>(p));
}

/// The sentence that refuses a file of which more than half of the faces, or of a cloud's points, would be
/// left out; none where enough is left. `points`: of the file, with those that are left out.
[[nodiscard]] std::optional<Error> too_much_left_out(const ReadNotes& read, std::size_t points = 0);

}  // namespace snug
