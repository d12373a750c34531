#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "snug/base/message.h"
#include "snug/base/side.h"
#include "snug/base/vec.h"
#include "snug/design/fit_options.h"
#include "snug/design/walls.h"
#include "snug/foam/block_map.h"
#include "snug/space/design_space.h"

namespace snug {

/// A recess of the foam below an item beside it, in whole blocks.
struct Notch {
    std::size_t item = 0;  ///< beside which it lies
    Side side = kBack;     ///< of the object on which it lies: back, front, left or right
    double at_mm = 0;      ///< its middle along the object's side, in design coordinates
    Vec3d size_mm;         ///< depth (x) below the parting level and extent along y and z
    Vec3d where;           ///< its middle at the parting level, in design coordinates
};

/// Two notches opposite each other, or why there are none (`no_notches`).
struct NotchPair {
    std::optional<std::array<Notch, 2>> notches;
    Message why_not;
};

/// Between which levels the foam lies that the notches are cut from: its parting level, and where it begins,
/// 0 in the lowest layer.
struct NotchLevels {
    int parting = 0;
    int under = 0;
};

/// What of its layer an object cuts itself. Where it is not `alone`, its notches go no deeper than its own
/// pocket and are no wider than two thirds of it, so that enough foam holds it.
struct NotchedObject {
    BlockMap own;
    bool alone = true;
};

/// Cuts the notches of one object out of the foam below its layer, from the object outwards: where they are
/// left to choose, across the object's narrower way and as near to the middle of what is cut as both find
/// room beside it, so that the object hangs level between two hands. They leave the walls that are wanted,
/// and at least one block, and never take foam from under what lies inside the object's outline at the
/// parting level, nor from under another; so both halves stay height fields. Two objects may share one.
/// `layer`: what is cut of all objects of the layer, which the notches join.
[[nodiscard]] NotchPair cut_notches(BlockMap& layer, const NotchedObject& object, const DesignSpace& space,
                                    NotchLevels levels, const NotchOptions& options, const Walls& wanted_mm);

}  // namespace snug
