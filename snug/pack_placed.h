#pragma once

#include <functional>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/foam/object_cut.h"
#include "snug/pipeline.h"

// The method from a placement on, for every kind of object: a mesh in memory, or one that is streamed.

namespace snug {

/// What only the object itself can tell.
struct PackSteps {
    std::function<Result<ObjectDepths>(const Placement&, const DesignSpace&)> depths;
    std::function<void(const Packing&, const ObjectDepths&, const HalfCuts&, std::vector<Finding>&)>
        find_object_problems;
    std::function<void(const Packing&, std::vector<Finding>&)> find_object_notes;
};
[[nodiscard]] Result<Packing> pack_placed(const Placement& placement, const Design& design,
                                          const PackSteps& steps);

/// From the file's unit to millimetres, for an object of this size in the file's unit. `in_mm`: the file
/// states its unit, so it is in mm already.
[[nodiscard]] double millimetres_per_unit(Vec3d size, const ObjectOptions& options, bool in_mm = false);

}  // namespace snug
