#pragma once

#include <emscripten/val.h>

#include "snug/formats/scene_tools.h"

namespace snug::wasm {

/// The page's tools for scenes (SceneTools in studio/src/engine/snug-wasm.d.ts): functions that never throw
/// and give what is asked for, or null if they cannot. A tool that is null is absent.
[[nodiscard]] SceneTools scene_tools_from(const emscripten::val& tools);

}  // namespace snug::wasm
