#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/space/case_space.h"

namespace snug::cli {

/// The options of a case as they were typed; none where they were not.
struct CaseArguments {
    std::optional<std::string> size_or_name, base, top;
    std::optional<double> play, radius;
};

void add_case_options(CLI::App& command, CaseArguments& arguments);

/// Puts what was typed into the design. `with_blocks`: the number of blocks was typed as well, which a case
/// does not leave open.
[[nodiscard]] Result<void> take_case(const CaseArguments& arguments, bool with_blocks, Design& design);

/// "a box: 425 x 284 x 155 mm inside, 2 mm of play on each side, lid 45 mm"
[[nodiscard]] Message case_text(const CaseSpace& fitted);
/// "left, lid: 410 x 278 x 12 mm"
[[nodiscard]] Message filler_text(const Filler& filler);

}  // namespace snug::cli
