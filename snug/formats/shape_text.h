#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "snug/base/result.h"
#include "snug/mesh/simple_solid.h"

// An object from measurements, as a person writes it (and as a .shape file has it), in millimetres:
//
//   box 143x87x40 r5 + cylinder 63x60 at 0,0,50
//
//   box X x Y x Z [rRADIUS]          its sides, and the radius of its edges
//   cylinder DIAMETER x LENGTH
//   cone DIAMETER x TOP x LENGTH     from the one diameter to the other; a TOP of 0 is a tip
//   ball DIAMETER
//
// Behind each, in any order: `at X,Y,Z`, where its middle stands; `along x|y|z`, where the axis of a cylinder
// or cone points to (z); `turn PSI,THETA,PHI` in degrees. Blanks, line ends and capitals do not matter; what
// stands behind # in a line is passed over.

namespace snug {

/// Sizes from 0.1 to 10,000 mm, at most 100 solids, places within 10 m. Fails (kind `input`) with a
/// sentence that names the solid and what it lacks.
[[nodiscard]] Result<std::vector<SimpleSolid>> parse_shape(std::string_view text);

/// What parse_shape() reads back, to a thousandth of a millimetre.
[[nodiscard]] std::string shape_text(const std::vector<SimpleSolid>& solids);

}  // namespace snug
