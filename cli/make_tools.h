#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "snug/base/result.h"
#include "snug/design/workshop_options.h"

// The options of `snug make` for bricks, mills and moulds.

namespace snug::cli {

/// As they were typed; none where they were not.
struct ToolArguments {
    std::optional<std::string> brick_unit, brick_colors, brick_rim, origin;
    std::vector<std::string> brick_sizes, brick_stock;
    std::optional<double> brick_capacity;
    std::optional<double> cutter, flute, step_down, stepover, feed, plunge, spindle, safe_height, pin;
    std::optional<double> mould_wall, mould_rim, draft;
};

void add_tool_options(CLI::App& make, ToolArguments& arguments);

/// Applies what was typed. Errors are of kind `usage` and name the option.
[[nodiscard]] Result<void> apply_tools(const ToolArguments& arguments, WorkshopOptions& options);

}  // namespace snug::cli
