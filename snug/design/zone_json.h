#pragma once

#include <nlohmann/json_fwd.hpp>

#include "snug/design/zone.h"

namespace snug {

/// [{"balls": [[x, y, z, r], ...], "part": 3, "keep_off_mm": 15, "press_kpa": 2, "loose": true}, ...]; what a
/// zone has not is left out.
[[nodiscard]] nlohmann::ordered_json zones_json(const Zones& zones);
/// False where it is something else, or has fields that no zone has.
[[nodiscard]] bool read_zones(const nlohmann::json& json, Zones& zones);

}  // namespace snug
