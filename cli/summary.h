#pragma once

#include <span>
#include <string>

#include "snug/design/project.h"
#include "snug/fabricate/kit/made.h"
#include "snug/object/object.h"
#include "snug/words/words.h"

namespace snug::cli {

/// What a packer wants to know of a packing with foams, in a dozen lines. An empty folder: nothing is
/// written.
[[nodiscard]] std::string summary(std::span<const Object> objects, const Project& project, const Made& made,
                                  const std::string& folder, Language language);

/// "34,834 vertices, 69,451 triangles, 155.7 x 154.3 x 120.7 mm, open (5 holes)"
[[nodiscard]] Message object_text(const Object& object);

}  // namespace snug::cli
