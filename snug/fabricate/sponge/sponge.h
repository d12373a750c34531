#pragma once

#include "snug/base/result.h"
#include "snug/design/workshop_options.h"
#include "snug/fabricate/kit/workshop_pack.h"

namespace snug {

/// For slit sponge and cubes, worked layer by layer:
///   sponge-plan.pdf      counts, the order of work, how deep each column goes (tables for large grids)
///   sponge-maps.pdf      a map at true size for each layer that is plucked, and the fit test; tiled
///   sponge/*.svg         the same maps, a file each
/// Layers that lose the same blocks share one map. Where the maps would fill more pages than anyone prints,
/// the PDF holds the fit test alone and a finding says so.
[[nodiscard]] Result<WorkshopPack> sponge_pack(const FoamDesign& design, const WorkshopOptions& options);

}  // namespace snug
