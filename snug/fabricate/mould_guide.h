#pragma once

#include <optional>
#include <vector>

#include "snug/design/workshop_options.h"
#include "snug/fabricate/mould_form.h"
#include "snug/fabricate/mould_parts.h"
#include "snug/fabricate/workshop_pack.h"

namespace snug {

/// A mould to print and what it came to.
struct Mould {
    MouldForm form;
    MouldedHalf made;
    std::vector<std::string> names;  ///< of its parts, as their files are called
};

/// What to print, the order of work, how much to pour, and each mould as it stands on the table, from above.
[[nodiscard]] DrawingDocument mould_guide(const FoamDesign& design, const std::vector<Mould>& moulds,
                                          const WorkshopOptions& options, std::size_t beds);

}  // namespace snug
