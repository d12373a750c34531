#pragma once

#include <string>

#include "snug/design/project.h"
#include "snug/fabricate/kit/made.h"
#include "snug/object/object.h"

namespace snug {

/// What was made and what a person must know of it; fields as the command line's contract names them. Without
/// foams the foam and wall fields are null; what was not measured is null or, for a search or a pack, left
/// out. Messages, labels and values of figures are in the language of `made`.
[[nodiscard]] std::string report_json(std::span<const Object> objects, const Project& project,
                                      const Made& made);

}  // namespace snug
