#pragma once

#include <string>

#include "wasm/values.h"

namespace snug::wasm {

/// {solids: [{kind, size, radius, along, turn, at}]} of an object from measurements (shape_text.h), or what
/// is wrong with the text. `size`: as the text has it, mm.
[[nodiscard]] val shape_val(const std::string& text);

}  // namespace snug::wasm
