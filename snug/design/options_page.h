#pragma once

#include <string>

namespace snug {

/// docs/options.md: every option by the stage of the method that it belongs to.
[[nodiscard]] std::string options_page();

}  // namespace snug
