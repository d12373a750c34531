#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "snug/base/vec.h"

namespace snug {

/// What of a raw scan is no part of the object. Nothing is dropped without a finding that says so.
struct CleanOptions {
    /// Numbers of separate parts as `snug inspect` lists them, from 1, the largest first.
    std::vector<int> drop_parts;
    double drop_below_mm = 0;  ///< parts whose longest side is shorter; 0: none
    /// A plinth or table: what lies behind the plane is cut off, and the cut closed. The first three numbers
    /// point to what is kept, the fourth is how far along them the plane lies from the file's origin, in mm.
    std::optional<std::array<double, 4>> cut_plane;
    friend bool operator==(const CleanOptions&, const CleanOptions&) = default;

    [[nodiscard]] bool none() const { return drop_parts.empty() && drop_below_mm == 0 && !cut_plane; }
};

/// What is out of range, as a sentence; none where all is well.
[[nodiscard]] std::optional<std::string> problem_of(const CleanOptions& options);

}  // namespace snug
