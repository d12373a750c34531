#pragma once

#include <string_view>
#include <vector>

#include "snug/fabricate/bricks/brick_build.h"

// What a half is put through, and what keeps it from falling then.

namespace snug {

enum class BrickLoad {
    standing,  ///< on the table as it is built, cavity up
    lifted,    ///< by its rim, cavity up: everything hangs from the rim's bricks
    turned,    ///< cavity down on its rim: a lid in use, and any half that is turned over
};
[[nodiscard]] std::string_view brick_load_name(BrickLoad load);  ///< standing, lifted, turned

/// Which bricks something outside the half supports, by their numbers in BrickBuild::bricks.
struct BrickSupports {
    BrickLoad load = BrickLoad::standing;
    /// Does not move, whatever pulls at it: hands hold it.
    std::vector<char> held;
    /// Presses on a level table, with its bottom where it stands, with its top where it was turned over.
    std::vector<char> resting;
};

/// The outline of a half are its cells of studs beside nothing: beside a cell without a brick, or the grid's
/// edge, from which one can go out between cells without bricks.
///   standing: the bricks at height 0 rest.
///   lifted:   the topmost level at which every cell of the outline is filled is the ring that hands take
///             hold of; the bricks of that ring that cover a cell of the outline are held.
///   turned:   the height at which most cells of the outline end (the higher of equals) is the rim; all
///             bricks that end there and carry none rest, as on a table or on the other half. What stands
///             out above the rim then hangs below it.
[[nodiscard]] BrickSupports brick_supports(const BrickBuild& build, const std::vector<BrickJoint>& joints,
                                           BrickLoad load);

/// Bricks that no chain of joints ties to a support, from the first to the last: they fall, whatever the
/// studs hold.
[[nodiscard]] std::vector<int> loose_bricks(const BrickSupports& supports,
                                            const std::vector<BrickJoint>& joints);

/// Whether every stud of every brick has a support straight below it, a brick or the table: then the weight
/// of each stud's column goes straight down and no stud has to pull.
[[nodiscard]] bool rests_throughout(const BrickBuild& build, const std::vector<BrickJoint>& joints,
                                    const BrickSupports& supports);

}  // namespace snug
