#pragma once

#include <optional>

#include "snug/base/message.h"
#include "snug/base/vec.h"
#include "snug/design/walls.h"
#include "snug/space/design_space.h"

namespace snug {

/// What of the space around an object a person may change, for findings that say what to do.
struct SpaceChoice {
    enum class Kind {
        fitted,  ///< as many blocks as the walls need: the walls may change
        blocks,  ///< chosen counts, which may change
        box,     ///< an upright case: its size is given
        shaped,  ///< a case with rounded corners or leaning walls
    };
    Kind kind = Kind::blocks;
    Walls wall_mm{};                 ///< of kind fitted: what was asked for
    Vec3d offset_mm;                 ///< of the object, from the centre of the space
    std::optional<Vec3d> inside_mm;  ///< of a case: height, width, length inside
    [[nodiscard]] bool is_case() const { return kind == Kind::box || kind == Kind::shaped; }
};

/// What gives each side at least `least_mm` of foam where it has `wall_mm` now, as a part of a sentence: an
/// option with its numbers that does it for all sides at once ("--blocks 32x18x20 would do"), or what else
/// can be done. `wall_mm` as in FitReport. In a chosen or fitted space and in an upright case the numbers are
/// exact: blocks are whole.
[[nodiscard]] Message wall_advice(const Walls& wall_mm, const Walls& least_mm, const DesignSpace& space,
                                  const SpaceChoice& choice);

}  // namespace snug
