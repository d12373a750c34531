#include "snug/design/case_options.h"

#include <algorithm>
#include <array>

#include "snug/base/text.h"

namespace snug {
namespace {

constexpr std::array<std::string_view, 3> kDivisions{"none", "across", "all"};  // as in Division
constexpr double kGreatestCase = 20000;                                         // mm

bool within(double value, double least, double most) {
    return value >= least && value <= most;
}

std::string mm(double value) {
    return number(value, 2) + " mm";
}

std::optional<std::string> problem_of_taper(const CrossSection& section, Vec3d inside, double play,
                                            const char* where) {
    if (!within(section.width, 0, inside.y) || !within(section.length, 0, inside.z))
        return std::string("the case must be widest at its parting line: ") + where +
               " it may measure up to " + number(inside.z, 2) + " x " + mm(inside.y) + ", not " +
               number(section.length, 2) + " x " + mm(section.width);
    if (std::min(section.width, section.length) <= 2 * play)
        return std::string("nothing of the case is left ") + where + " within its play of " + mm(play) +
               " on each side";
    return {};
}

}  // namespace

std::string_view division_name(Division division) {
    return kDivisions[static_cast<std::size_t>(division)];
}

std::optional<Division> division_from_name(std::string_view name) {
    const auto found = std::find(kDivisions.begin(), kDivisions.end(), name);
    if (found == kDivisions.end()) return {};
    return static_cast<Division>(found - kDivisions.begin());
}

std::optional<std::string> problem_of(const CaseOptions& options) {
    if (!within(options.play_mm, 0, kGreatestCase))
        return "the play must be 0 mm or more, not " + mm(options.play_mm);
    if (options.divisor && !within(*options.divisor, 1, 1e6))
        return "the divisor of the volumetric weight must be 1 to 1000000 cm3 for one kg, not " +
               number(*options.divisor, 4);
    if (!options.inside_mm) return {};
    const Vec3d inside = *options.inside_mm;
    const double least = std::min({inside.x, inside.y, inside.z});
    if (!within(least, 1, kGreatestCase) ||
        !within(std::max({inside.x, inside.y, inside.z}), 1, kGreatestCase))
        return "a case measures 1 to 20000 mm inside on each side, not " +
               dimensions({inside.z, inside.y, inside.x}, 2);
    if (least <= 2 * options.play_mm)
        return "nothing of the case of " + dimensions({inside.z, inside.y, inside.x}) +
               " mm is left within its play of " + mm(options.play_mm) + " on each side";
    if (options.lid_mm && !(*options.lid_mm >= 0 && *options.lid_mm < inside.x))
        return "the lid must be 0 mm or more and less than the case's height of " + mm(inside.x) + ", not " +
               mm(*options.lid_mm);
    if (options.top_mm && options.lid_mm.value_or(0) <= 0)
        return "what the case measures at the roof of its lid needs the lid's height: give both (--case "
               "LxWxH:LID with --case-top), or leave it out";
    double narrowest = std::min(inside.y, inside.z);
    for (const auto& section : {options.base_mm, options.top_mm})
        if (section) narrowest = std::min({narrowest, section->width, section->length});
    if (options.base_mm)
        if (auto problem = problem_of_taper(*options.base_mm, inside, options.play_mm, "at its floor"))
            return problem;
    if (options.top_mm)
        if (auto problem = problem_of_taper(*options.top_mm, inside, options.play_mm, "at its roof"))
            return problem;
    if (!within(options.corner_radius_mm, 0, narrowest / 2))
        return "the corner radius must be 0 to " + mm(narrowest / 2) + " (half of the narrowest side), not " +
               mm(options.corner_radius_mm);
    return {};
}

}  // namespace snug
