#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "snug/design/option_list.h"

// Options as a project file has them.

namespace snug {

/// The options of the list, each struct an object, in the table's order.
[[nodiscard]] nlohmann::ordered_json json_of(const OptionList& list);
[[nodiscard]] nlohmann::ordered_json json_of(const Option& option);

/// Puts what `json` names into the options of the list; what is missing stays as it is. What is wrong or
/// unknown comes back as a sentence that begins with its path below `prefix` ("design.").
[[nodiscard]] std::optional<Message> read_options(const nlohmann::json& json, const OptionList& list,
                                                  const std::string& prefix);
/// Of a design, whose optional groups and lists are as `json` has them.
[[nodiscard]] std::optional<Message> read_options(const nlohmann::json& json, Design& design,
                                                  const std::string& prefix);

}  // namespace snug
