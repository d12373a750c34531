#pragma once

#include <span>
#include <string_view>

// The catalogue of words: what Snug says, English and Japanese side by side. A row of a topic's file is used
// by its code: say("capped", {{"holes", 2}}). In its sentences stand, for the values of the message,
//   - {name}           the value: text as it is, a count with groups (1,383,712), messages behind each other
//   - {name|one|many}  one of two words, by a count
//   - {name,}          messages as a list: "a, b, c"
//   - {name;}          "a; b; c"
//   - {name&}          "a, b and c"
//   - {name/}          "a, b or c"
// Both languages use the same values; what only chooses a word may be in one of them alone.

namespace snug {

struct Wording {
    std::string_view code, english, japanese;
};

/// The row of a code, whichever topic it stands in (catalogue.cpp lists them); null where there is none.
[[nodiscard]] const Wording* wording(std::string_view code);

}  // namespace snug
