#include "snug/fabricate/kit/case_text.h"

#include <string>
#include <vector>

#include "snug/base/text.h"
#include "snug/words/pieces.h"
#include "snug/words/sides.h"
#include "snug/words/words.h"

namespace snug {
namespace {

/// "410 x 278 x 12 mm"
std::string length_first_text(Vec3d size) {
    return dimensions({size.z, size.y, size.x}) + " mm";
}

}  // namespace

Message case_text(const CaseSpace& fitted) {
    const CaseOptions& options = fitted.options;
    std::vector<Message> name, lid;
    if (!options.name.empty()) name.push_back(as_it_is(options.name + ": "));
    if (options.lid_mm) lid.push_back(say("summary.lid", {{"mm", number(*options.lid_mm)}}));
    return say("summary.case_of", {{"name", name},
                                   {"inside", length_first_text(*options.inside_mm)},
                                   {"play", number(options.play_mm)},
                                   {"lid", lid}});
}

Message filler_text(const Filler& filler) {
    return say("summary.filler", {{"side", side_text(filler.side)},
                                  {"half", half_of(filler.lid ? Half::lid : Half::lower)},
                                  {"size", length_first_text(filler.size_mm)}});
}

}  // namespace snug
