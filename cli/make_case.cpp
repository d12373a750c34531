#include "cli/make_case.h"

#include <fmt/core.h>

#include "snug/base/text.h"
#include "snug/words/pieces.h"
#include "snug/words/sides.h"
#include "snug/words/words.h"

namespace snug::cli {
namespace {

/// "410 x 278 x 12 mm"
std::string size_text(Vec3d size) {
    return dimensions({size.z, size.y, size.x}) + " mm";
}

}  // namespace

Message case_text(const CaseSpace& fitted) {
    const CaseOptions& options = fitted.options;
    std::vector<Message> name, lid;
    if (!options.name.empty()) name.push_back(as_it_is(options.name + ": "));
    if (options.lid_mm) lid.push_back(say("summary.lid", {{"mm", number(*options.lid_mm)}}));
    return say("summary.case_of", {{"name", name},
                                   {"inside", size_text(*options.inside_mm)},
                                   {"play", number(options.play_mm)},
                                   {"lid", lid}});
}

Message filler_text(const Filler& filler) {
    return say("summary.filler", {{"side", side_text(filler.side)},
                                  {"half", half_of(filler.lid ? Half::lid : Half::lower)},
                                  {"size", size_text(filler.size_mm)}});
}

}  // namespace snug::cli
