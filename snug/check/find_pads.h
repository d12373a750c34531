#pragma once

#include <vector>

#include "snug/base/finding.h"
#include "snug/check/packing.h"
#include "snug/design/fit_options.h"

namespace snug {

/// Of a packing with pads, once its drops were looked at: `pads` (note) that there are any and what holds
/// them; `pads_left_out` (note) where there are more than are listed; where those above items may press on
/// them `pads_press`, how hard (a warning above its own weight), or `pads_press_unknown` (warning), where no
/// curve of the foam tells.
void find_pads(const Packing& packing, const PadOptions& options, std::vector<Finding>& findings);

}  // namespace snug
