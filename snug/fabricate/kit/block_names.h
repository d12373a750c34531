#pragma once

#include <string>

namespace snug {

/// The names of a column of blocks, the same in both halves: A, B, ... Z, AA, ... from BACK, and 1, 2, ...
/// along k.
[[nodiscard]] std::string row_name(int row_from_back);
[[nodiscard]] std::string column_name(int column);

}  // namespace snug
