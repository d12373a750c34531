#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/message.h"

namespace snug {

constexpr std::size_t kMostEdits = 20000;

/// What a hand changes of one column of a piece, whatever else the design comes to: blocks taken out of it,
/// or put back, where it faces what lies between it and the next piece.
struct HandEdit {
    std::string piece;   ///< "lower", "middle-1" and so on, "upper"
    int j = 0, k = 0;    ///< the column along y and z, from 0
    int blocks = 0;      ///< above 0: so many more taken out than what is computed; below: put back
    bool under = false;  ///< of a middle piece: at its face below
    friend bool operator==(const HandEdit&, const HandEdit&) = default;
};
using HandEdits = std::vector<HandEdit>;

/// "lower:12:7:1" takes one block out, "upper:12:7:-2" puts two back; "middle-1:12:7:1:under" at the face
/// below; more of them behind commas. None where the text is something else.
[[nodiscard]] std::optional<HandEdits> typed_edits(std::string_view text);
/// What typed_edits() reads back; none where there are no edits.
[[nodiscard]] std::optional<std::string> text_of(const HandEdits& edits);

/// The number of a middle piece; none of another.
[[nodiscard]] std::optional<int> middle_number(const HandEdit& edit);

/// What is wrong with the first that is wrong, numbered from 1.
[[nodiscard]] std::optional<Message> problem_of(const HandEdits& edits);

}  // namespace snug
