#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "snug/search/mask_packer.h"

namespace snug {

/// Pieces on sheets of one size. Bins of the layout are sheets.
struct PackedSheets {
    MaskLayout layout;
    std::vector<int> rows;  ///< that each sheet is used up to, counted from its first
};

/// What sheets may be, and what is known of them.
struct SheetTask {
    int rows = 0, columns = 0;
    int most_sheets = 1;  ///< more do not count
    std::uint64_t seed = 1;
    long long work = 0;  ///< places looked at in all, see MaskPacker::work()
};

/// The pieces on as few sheets as are found to hold them, each used up to as few rows as may be. None where
/// not even so many as are allowed held them, or one piece does not go in. The same for the same seed on
/// every machine. No piece may be locked.
[[nodiscard]] std::optional<PackedSheets> fewest_sheets(const MaskProblem& problem, const SheetTask& task);

}  // namespace snug
