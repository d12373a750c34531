#pragma once

#include <vector>

#include "snug/base/finding.h"
#include "snug/depth/object_depths.h"
#include "snug/foam/object_cut.h"
#include "snug/object/object.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

namespace snug {

/// What may be wrong with an object of any kind where it lies, in the half that sees it first: `open` and, of
/// a whole mesh, `uncut_part` (dangers).
void find_object_problems(const Object& object, const Placement& placement, const DesignSpace& space,
                          const ObjectDepths& depths, const HalfCuts& cuts, std::vector<Finding>& findings);

/// What a person must know of the object itself: what was left out, dropped or closed, of what kind it is and
/// what is therefore not known (`cloud`, `streamed`), options that meant nothing to it.
void find_object_notes(const Object& object, const Placement& placement, std::vector<Finding>& findings);

}  // namespace snug
