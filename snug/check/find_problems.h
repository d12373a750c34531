#pragma once

#include <span>
#include <vector>

#include "snug/base/finding.h"
#include "snug/check/fit_report.h"
#include "snug/check/wall_advice.h"
#include "snug/design/design.h"
#include "snug/foam/block_map.h"
#include "snug/mesh/measure.h"
#include "snug/mesh/mesh.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

// Each function looks for one kind of trouble and appends what it found. `choice`: how the space was
// chosen, so that nobody is told to take more blocks where the case decides how many there are.

namespace snug {

/// Foam that would grow inside an open object: columns in which the spans of its holes reach beyond the
/// surface itself, so that the two together would cut more blocks. `hole_spans` as made by span_of_loops().
/// Code `open` (danger).
void find_open_holes(const Mesh& hole_spans, const Placement& placement, const DesignSpace& space,
                     Reach reach, const DepthMap& depths, const BlockMap& blocks,
                     std::vector<Finding>& findings);

/// A connected part of the object that cuts no block at all: `uncut_part` (danger). Where the holes are
/// `capped`, what closes the part's own holes belongs to it, and caps are no parts of their own.
void find_uncut_parts(const Mesh& mesh, const MeshMeasure& measure, bool capped, const Placement& placement,
                      const DesignSpace& space, Reach reach, const BlockMap& blocks,
                      std::vector<Finding>& findings);

/// No foam between object and case: `no_floor`, `no_roof`, `touches_case` (danger); below 25 mm of what is to
/// `cushion`: `thin_floor`, `thin_roof`, `thin_wall`; below the walls that the design wants:
/// `wall_below_wanted` (warnings). Each says what of the choice would give the walls. A tray wants none
/// above.
void find_thin_walls(const FitReport& fit, std::span<const BlockMap> layers, const DesignSpace& space,
                     const Walls& wanted_mm, bool cushion, const SpaceChoice& choice,
                     std::vector<Finding>& findings);

/// A foam half in more than one piece, or without any foam: `lower_pieces`, `upper_pieces` (warning),
/// `no_lower`, `no_upper` (danger); between layers `middle_pieces`, `no_middle`.
void find_pieces(const FitReport& fit, const SpaceChoice& choice, std::vector<Finding>& findings);

/// An object in several separate parts, with sizes: `parts` (note), `specks` (warning) where a part is tiny
/// and far from all others.
void find_parts(const MeshMeasure& measure, const Placement& placement, std::vector<Finding>& findings);

}  // namespace snug
