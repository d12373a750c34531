#include "snug/foam/space_for.h"

#include <algorithm>

#include "snug/base/text.h"
#include "snug/foam/notches.h"
#include "snug/space/fitted_space.h"

namespace snug {

Vec3d shift_between_walls(const SpaceOptions& space, bool in_case) {
    return space.blocks || in_case ? Vec3d{} : fitted_shift(space.block_mm, wanted_wall_mm(space));
}

Result<DesignSpace> space_for(Box3d placed, const Design& design) {
    const SpaceOptions& options = design.space;
    if (options.blocks) return DesignSpace{*options.blocks, options.block_mm};
    const Vec3d shift = shift_between_walls(options, false);
    placed = {placed.min - shift, placed.max - shift};
    Box3d room = grown(placed, design.cut.whole_clearance_mm());
    if (design.fit.notches) room = with_room_for_notches(room, options.block_mm, *design.fit.notches);
    const Vec3d counts = fitted_blocks(room, options.block_mm, wanted_wall_mm(options));
    if (std::max({counts.x, counts.y, counts.z}) > kMostBlocks)
        return fail(ErrorKind::usage, "the object and its walls would need " + dimensions(counts, 0) +
                                          " blocks, more than 4096 on an axis: choose larger blocks");
    return DesignSpace{vec_cast<int>(counts), options.block_mm};
}

}  // namespace snug
