#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "snug/base/result.h"
#include "snug/check/bearing.h"
#include "snug/design/design.h"
#include "snug/foam/notches.h"

namespace snug::cli {

/// The options of the fit as they were typed; none where they were not.
struct FitArguments {
    std::optional<std::string> clearance, notches, notch_axis, notch_at;
    std::optional<double> liner, least_rib;
    bool cut_on_touch = false;
};

void add_fit_options(CLI::App& command, FitArguments& arguments);

/// Puts what was typed into the design. Fails with kind `usage`.
[[nodiscard]] Result<void> take_fit(const FitArguments& arguments, Design& design);

/// Lines for people: where the notches are, and what the object lies on.
[[nodiscard]] Message notch_text(const Notch& notch);
[[nodiscard]] Message bearing_text(const BearingReport& bearing, const Design& design);

}  // namespace snug::cli
