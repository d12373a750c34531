#include "snug/design/mould_options.h"

#include "snug/base/range.h"

namespace snug {

std::optional<std::string> problem_of(const MouldOptions& o) {
    if (!within(o.wall_mm, 0.4, 100)) return out_of_range("the mould's wall", o.wall_mm, 0.4, 100);
    if (!within(o.rim_mm, 0, 200)) return out_of_range("the mould's rim", o.rim_mm, 0, 200);
    if (!within(o.draft_deg, 0, 15)) return out_of_range("the mould's draft", o.draft_deg, 0, 15, " degrees");
    return {};
}

}  // namespace snug
