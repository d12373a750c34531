#include "snug/search/shock_margins.h"

#include <span>
#include <utility>

namespace snug {

ShockMargins::ShockMargins(const Object& object, Design design, PackIt pack_it,
                           std::array<double, 6> at_start, ShockEstimate estimate)
    : object_(&object),
      design_(std::move(design)),
      pack_it_(std::move(pack_it)),
      at_start_(at_start),
      estimate_(std::move(estimate)) {}

Result<ShockMargins> ShockMargins::start(const Object& object, const Design& design, const DesignSpace& space,
                                         PackIt pack_it) {
    if (const auto error = lacking_for_search(design)) return tl::unexpected(*error);
    Design placed = design;
    if (!placed.case_options.inside_mm) placed.space.blocks = space.blocks;
    const std::span<const Object> alone(&object, 1);
    const auto start = packed_shocks(alone, placed, pack_it);
    if (!start) return tl::unexpected(start.error());
    const auto lines = axis_lines(alone, start->packing.items, start->packing.space, 0);
    if (!lines) return tl::unexpected(lines.error());
    return ShockMargins(object, std::move(placed), std::move(pack_it), start->protection.margins(),
                        ShockEstimate(object.mesh, *start, *lines));
}

std::optional<std::array<double, 6>> ShockMargins::in_full(Vec3d rotation_deg, Vec3d offset_mm) const {
    Design placed = design_;
    placed.placement = {rotation_deg, offset_mm};
    const auto found = packed_shocks(std::span(object_, 1), placed, pack_it_);
    if (!found) return {};
    return found->protection.margins();
}

}  // namespace snug
