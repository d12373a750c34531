#pragma once

#include <string>
#include <string_view>

#include "snug/design/option_list.h"

namespace snug {

/// What kind of value an option has: "switch", "integer", "number", "text", "word", "numbers", "integers",
/// "words", "pieces", "weights"; "missing" for a group that is absent.
[[nodiscard]] std::string_view kind_of(const Option& option);

/// The table as JSON, for the page's fields: {path: {kind, label, help, unit, least, most, above, or_zero,
/// step, words, optional, default, flag, scope}}. What an option does not have is missing; `default` is as a
/// project has it.
[[nodiscard]] std::string options_schema();

}  // namespace snug
