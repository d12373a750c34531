#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "snug/design/flags.h"
#include "snug/design/project.h"
#include "snug/words/words.h"

namespace snug {

/// What to type behind `snug make OBJECT` so that it gives this design: what differs from what the preset and
/// the way of working bring, and nothing else. Where no flag says an option's value, --set does.
[[nodiscard]] std::vector<TypedFlag> flags_for(const Design& design, const KnownNames& known);

/// The same as a line for a shell: "snug make vase.stl --blocks=auto -o vase-foam". `language`: of its pages.
[[nodiscard]] std::string command_line(std::string_view file, const Design& design, const KnownNames& known,
                                       Language language = Language::english);

/// Of a project of any number of items: "snug make a.stl:move=0x40x0 b.stl:count=2 ...". `files`: of each
/// object, one at least.
[[nodiscard]] std::string command_line(Project project, std::span<const std::string> files,
                                       const KnownNames& known, Language language = Language::english);

}  // namespace snug
