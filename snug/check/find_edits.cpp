#include "snug/check/find_edits.h"

#include <algorithm>

#include "snug/base/text.h"

namespace snug {

void find_edits(const Packing& packing, const HandEdits& edits, std::vector<Finding>& findings) {
    std::size_t unapplied = 0, pressed = 0;
    const EditOutcome* first = nullptr;
    const EditOutcome* closest = nullptr;
    for (const EditOutcome& outcome : packing.edits) {
        if (outcome.why_not && unapplied++ == 0) first = &outcome;
        if (!outcome.left_mm) continue;
        ++pressed;
        if (!closest || *outcome.left_mm < *closest->left_mm) closest = &outcome;
    }
    if (closest)
        findings.push_back(
            {Severity::warning,
             say("edit_in_clearance", {{"columns", pressed}, {"mm", number(*closest->left_mm, 2)}}),
             closest->where});
    if (first)
        findings.push_back(
            {Severity::note, say("edits_unapplied", {{"edits", unapplied},
                                                     {"all", edits.size()},
                                                     {"first", *text_of(HandEdits{edits[first->edit]})},
                                                     {"why", *first->why_not}})});
}

}  // namespace snug
