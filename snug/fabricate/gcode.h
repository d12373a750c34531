#pragma once

#include <string>
#include <vector>

#include "snug/base/result.h"
#include "snug/fabricate/mill_path.h"

namespace snug {

/// A program for GRBL 1.1: millimetres, absolute, X0 Y0 at the near left corner or the middle of the stock,
/// Z0 at its top; one tool; lines of at most 80 characters, at most 3 digits behind the point, plain ASCII.
/// `title` and `remarks` become comments.
[[nodiscard]] std::string grbl_program(const MillPath& path, Vec2d stock_mm, const MillOptions& options,
                                       const std::string& title, const std::vector<std::string>& remarks);

}  // namespace snug
