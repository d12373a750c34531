#pragma once

#include <string>

#include "snug/design/design.h"
#include "snug/space/case_space.h"

namespace snug::cli {

/// What a packer needs to know of the case: its sizes, where it parts, and the strips to cut.
[[nodiscard]] std::string case_lines(const CaseSpace& fitted, int parting_level);

}  // namespace snug::cli
