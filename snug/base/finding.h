#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/message.h"
#include "snug/base/vec.h"

namespace snug {

enum class Severity {
    danger,  ///< a foam that would harm the object, or cannot be made
    warning,
    note,
};
[[nodiscard]] std::string_view severity_name(Severity severity);

/// Something a person must know.
struct Finding {
    Severity severity = Severity::note;
    Message message;                  ///< a sentence that says what it is and what to do
    std::optional<Vec3d> where = {};  ///< a place in design coordinates, if it has one
    std::string of = {};  ///< the item that it is of, as people call it; empty where there is one alone

    /// The stable word for programs, e.g. "open": the message's code up to a '/', behind which several
    /// sentences of one kind of finding differ.
    [[nodiscard]] std::string_view code() const;
};

/// The sentence, with the item's name before it where there are several.
[[nodiscard]] Message said_of_item(const Finding& finding);

/// Dangers first, then warnings, then notes; within each the order they were found in.
void sort_by_severity(std::vector<Finding>& findings);

}  // namespace snug
