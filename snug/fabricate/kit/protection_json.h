#pragma once

#include <nlohmann/json_fwd.hpp>

#include "snug/check/protection_report.h"

namespace snug {

/// `protection` of report.json. Of several items `faces` are those of the item that is worst off on each, and
/// `items` has all of them.
[[nodiscard]] nlohmann::ordered_json protection_json(const Protection& protection);

}  // namespace snug
