#pragma once

#include <nlohmann/json.hpp>

#include "snug/design/hand_edit.h"

namespace snug {

/// An array of {piece, j, k, blocks} and, at a middle piece's face below, under.
[[nodiscard]] nlohmann::ordered_json edits_json(const HandEdits& edits);
/// False where it is no such array.
[[nodiscard]] bool read_edits(const nlohmann::json& json, HandEdits& edits);

}  // namespace snug
