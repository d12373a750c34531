#pragma once

#include <string>

#include "snug/fabricate/drawing.h"

namespace snug {

/// DXF R12 (AC1009): lines as POLYLINE, circles as CIRCLE, by layers with their nearest standard colours;
/// text is left out. One unit is 1 mm, y upward, the origin at the sheet's lower left corner.
[[nodiscard]] std::string drawing_dxf(const Drawing& drawing);

}  // namespace snug
