#pragma once

#include <string>

#include "snug/drawing/drawing.h"

namespace snug {

/// DXF of AutoCAD 2000 (AC1015) in stated millimetres: lines as LWPOLYLINE, circles as CIRCLE, by layers with
/// their nearest standard colours; text is left out. y upward, the origin at the sheet's lower left corner.
[[nodiscard]] std::string drawing_dxf(const Drawing& drawing);

}  // namespace snug
