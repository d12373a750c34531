#pragma once

#include <nlohmann/json.hpp>

#include "snug/design/json_reader.h"
#include "snug/design/workshop_options.h"

namespace snug {

/// The field `workshop` of a project's design.
[[nodiscard]] nlohmann::ordered_json workshop_json(const WorkshopOptions& workshop);

/// Reads it back; what is missing stays as it is. The parent learns what is wrong.
void read_workshop(JsonReader json, WorkshopOptions& workshop, JsonReader& parent);

}  // namespace snug
