#pragma once

#include <string>
#include <vector>

#include "snug/base/result.h"
#include "snug/fabricate/mill/mill_path.h"

namespace snug {

/// The first line of a program: what it mills, which stays whole, and whose name, which is shortened.
struct ProgramTitle {
    std::string what;         ///< "LOWER, cavity up"
    std::string object_name;  ///< UTF-8, anything
};

/// A program for GRBL 1.1: millimetres, absolute, X0 Y0 at the near left corner or the middle of the stock,
/// Z0 at its top; one tool; lines of at most 80 characters with their end, at most 3 digits behind the point.
/// `title` and `remarks` become comments in the letters of plain_name.h; long remarks take several lines.
[[nodiscard]] std::string grbl_program(const MillPath& path, Vec2d stock_mm, const MillOptions& options,
                                       const ProgramTitle& title, const std::vector<std::string>& remarks);

}  // namespace snug
