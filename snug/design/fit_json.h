#pragma once

#include <nlohmann/json.hpp>

#include "snug/design/clearance.h"
#include "snug/design/fit_options.h"
#include "snug/design/json_reader.h"

namespace snug {

/// The field `fit` of a project's design.
[[nodiscard]] nlohmann::ordered_json fit_json(const FitOptions& fit);

/// Reads it back; what is missing stays as it is. The parent learns what is wrong.
void read_fit(JsonReader json, FitOptions& fit, JsonReader& parent);

/// One number where all are equal, else six: x, y, z of the lower foam, then of the upper.
[[nodiscard]] nlohmann::ordered_json clearance_json(const Clearance& clearance);
void read_clearance(JsonReader& json, const char* name, Clearance& clearance);

}  // namespace snug
