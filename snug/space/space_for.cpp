#include "snug/space/space_for.h"

#include <algorithm>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/space/available.h"
#include "snug/space/fitted_space.h"

namespace snug {
namespace {

/// A case that is divided exactly may have smaller blocks than those the clearance was checked for.
std::optional<Error> too_squeezed(const DesignSpace& space, double clearance) {
    const double least = least_clearance_mm(space.block_mm);
    if (clearance >= least) return {};
    return Error{ErrorKind::usage, say("case.squeezed", {{"block", dimensions(space.block_mm)},
                                                         {"least", number(least, 4)},
                                                         {"clearance", number(clearance, 4)}})};
}

Result<DesignSpace> fitted_to(Box3d room, const Design& design) {
    const SpaceOptions& options = design.space;
    const Vec3d shift = shift_between_walls(options, false);
    room = {room.min - shift, room.max - shift};
    if (design.fit.notches) room = with_room_for_notches(room, options.block_mm, *design.fit.notches);
    const Vec3d counts = fitted_blocks(room, options.block_mm, wanted_wall_mm(options));
    if (std::max({counts.x, counts.y, counts.z}) > kMostBlocks)
        return fail(ErrorKind::usage, say("space.too_many_blocks", {{"blocks", dimensions(counts, 0)}}));
    return DesignSpace{vec_cast<int>(counts), options.block_mm};
}

PackedSpace plain_box(const DesignSpace& space) {
    return {space, {}, all_blocks(space.blocks)};
}

Result<PackedSpace> in_case(double least_clearance, const Design& design) {
    auto fitted = case_space(design);
    if (!fitted) return tl::unexpected(fitted.error());
    if (const auto error = too_squeezed(fitted->space, least_clearance)) return tl::unexpected(*error);
    const DesignSpace space = fitted->space;
    Grid<Run> available = available_blocks(*fitted);
    return PackedSpace{space, std::move(*fitted), std::move(available)};
}

}  // namespace

Result<CaseSpace> case_space(const Design& design) {
    auto fitted = case_space(design.case_options, design.space.block_mm);
    if (fitted && design.space.open) return standing_on_floor(std::move(*fitted));
    return fitted;
}

Result<PackedSpace> space_for(const Box3d& room, double least_clearance, const Design& design) {
    if (design.case_options.inside_mm) return in_case(least_clearance, design);
    if (design.space.blocks) return plain_box({*design.space.blocks, design.space.block_mm});
    const auto fitted = fitted_to(room, design);
    if (!fitted) return tl::unexpected(fitted.error());
    return plain_box(*fitted);
}

Result<PackedSpace> space_for(const Box3d& placed, const Design& design) {
    const Clearance clearance = design.cut.whole_clearance_mm();
    return space_for(grown(placed, clearance), clearance.least(), design);
}

}  // namespace snug
