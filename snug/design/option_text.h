#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/option_list.h"

// Options as they are typed.

namespace snug {

/// A number as it is typed; none where the text is something else. Exponents are read, commas are not.
[[nodiscard]] std::optional<double> typed_number(std::string_view text);
[[nodiscard]] std::optional<int> typed_integer(std::string_view text);

/// Numbers between separators; empty where one is no number.
[[nodiscard]] std::vector<double> typed_numbers(std::string_view text, char separator);

/// The shortest text that reads back as the same number.
[[nodiscard]] std::string exact(double value);
[[nodiscard]] std::string exact(std::initializer_list<double> values, char separator);

/// Puts what was typed behind `flag` into the option. Errors are of kind `usage`, name the flag and show what
/// it takes. Ranges are not looked at.
[[nodiscard]] Result<void> take_text(const Option& option, std::string_view text);

/// What to type for the option's value, empty for a switch that is on; none where nothing says it.
[[nodiscard]] std::optional<std::string> text_of(const Option& option);

/// An Error that says what a flag takes: "--units takes mm, cm, m or in, not "miles"".
[[nodiscard]] tl::unexpected<Error> not_what_it_takes(std::string_view flag, Message what,
                                                      std::string_view text);

}  // namespace snug
