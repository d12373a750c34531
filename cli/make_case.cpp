#include "cli/make_case.h"

#include <fmt/core.h>

#include "snug/base/text.h"

namespace snug::cli {
namespace {

/// "410 x 278 x 12 mm"
std::string size_text(Vec3d size) {
    return dimensions({size.z, size.y, size.x}) + " mm";
}

}  // namespace

std::string case_lines(const CaseSpace& fitted, int parting_level) {
    const CaseOptions& options = fitted.options;
    std::string text = fmt::format("{:<10}{}{} inside, {} mm of play on each side", "Case",
                                   options.name.empty() ? "" : options.name + ": ",
                                   size_text(*options.inside_mm), number(options.play_mm));
    if (options.lid_mm) text += fmt::format(", lid {} mm", number(*options.lid_mm));
    text += "\n";
    std::string label = "Fillers";
    for (const Filler& filler : fillers(fitted, parting_level)) {
        text += fmt::format("{:<10}{}, {}: {}\n", label, side_name(filler.side),
                            filler.lid ? "lid" : "lower half", size_text(filler.size_mm));
        label.clear();
    }
    return text;
}

}  // namespace snug::cli
