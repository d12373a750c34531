#pragma once

#include <string>

#include "snug/fabricate/kit/workshop_pack.h"

namespace snug {

/// "start-here.txt": what a pack holds, in the order in which a maker takes it up, and which file to open
/// first. `pack`: with all its documents, the one to begin with first.
[[nodiscard]] PackFile start_here(const WorkshopPack& pack, const std::string& object_name,
                                  Language language);

}  // namespace snug
