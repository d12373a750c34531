#pragma once

#include <string>

#include <emscripten/val.h>

#include "snug/base/result.h"
#include "snug/design/project.h"

// Projects between JavaScript and the library: a design as a JSON text, and its objects' files beside it.

namespace snug::wasm {

/// `objects`: each {name, bytes, sha256, own}, the last as a design's JSON text or null. Fails as
/// parse_design() does; that items are of objects that there are is not looked at.
[[nodiscard]] Result<Project> project_from(const std::string& design, const emscripten::val& objects);

/// {text, whole} of a zip that was a pack (find_packed_project()): its project's text, null where there is
/// none, and whether its object is in it. `tools`: as scene_tools_from() takes them.
[[nodiscard]] emscripten::val packed_project(const emscripten::val& zip, const emscripten::val& tools);

/// {objects, design, dependent} of a project's text: its objects as above, each of several with what it has
/// of its own; of one item all stands in the design. The last are JSON texts (dependent_options()).
[[nodiscard]] emscripten::val parse(const std::string& project_text);

}  // namespace snug::wasm
