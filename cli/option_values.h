#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/base/vec2.h"
#include "snug/design/clearance.h"
#include "snug/design/walls.h"

namespace snug::cli {

// The composite values of options. Errors (kind `usage`) name the option and show what it takes.

/// "30x18x18"
[[nodiscard]] Result<Vec3i> parse_counts(const std::string& option, std::string_view text);

/// "15x15x22", mm
[[nodiscard]] Result<Vec3d> parse_sizes(const std::string& option, std::string_view text);

/// "1000x600", mm
[[nodiscard]] Result<Vec2d> parse_rectangle(const std::string& option, std::string_view text);

/// "0,90,0"
[[nodiscard]] Result<Vec3d> parse_vector(const std::string& option, std::string_view text);

/// "50", "40,50,50" (x, y, z) or six sides "60,40,50,50,50,50", mm
[[nodiscard]] Result<Walls> parse_walls(const std::string& option, std::string_view text);

/// "2", "0,2,2" (x, y, z) or "0,1,1,2,3,3" (the lower foam's, then the upper's), mm
[[nodiscard]] Result<Clearance> parse_clearance(const std::string& option, std::string_view text);

/// "80x40" or "80x40x25", mm; the third is 0 where it was not named.
[[nodiscard]] Result<Vec3d> parse_notches(const std::string& option, std::string_view text);

/// "-20,10", or one number for both, mm
[[nodiscard]] Result<Vec2d> parse_pair(const std::string& option, std::string_view text);

/// "45" or "12.5", mm
[[nodiscard]] Result<double> parse_length(const std::string& option, std::string_view text);

/// "2,5-9": 2, 5, 6, 7, 8, 9; at most 100,000 of them
[[nodiscard]] Result<std::vector<int>> parse_numbers(const std::string& option, std::string_view text);

/// "0,0,1,12": a direction and a distance
[[nodiscard]] Result<std::array<double, 4>> parse_plane(const std::string& option, std::string_view text);

/// "7"
[[nodiscard]] Result<int> parse_integer(const std::string& option, std::string_view text);

/// "12.50", "12.50EUR", "12.50 EUR"
struct Price {
    double amount = 0;
    std::string currency;  ///< may be empty
};
[[nodiscard]] Result<Price> parse_price(const std::string& option, std::string_view text);

}  // namespace snug::cli
