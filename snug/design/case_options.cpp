#include "snug/design/case_options.h"

#include <algorithm>

#include "snug/base/range.h"
#include "snug/base/text.h"
#include "snug/design/option_list.h"
#include "snug/design/option_text.h"

namespace snug {
namespace {

std::string mm(double value) {
    return number(value, 2) + " mm";
}

std::optional<Message> problem_of_taper(const CrossSection& section, Vec3d inside, double play,
                                        const Message& where) {
    if (!within(section.width, 0, inside.y) || !within(section.length, 0, inside.z))
        return say("case.not_widest", {{"where", where},
                                       {"most", number(inside.z, 2) + " x " + mm(inside.y)},
                                       {"found", number(section.length, 2) + " x " + mm(section.width)}});
    if (std::min(section.width, section.length) <= 2 * play)
        return say("case.nothing_left", {{"where", where}, {"play", mm(play)}});
    return {};
}

Result<void> take_sizes(std::string_view text, CaseOptions& options) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const std::vector<double> sizes = typed_numbers(text.substr(0, colon), 'x');
    const auto lid = colon < text.size() ? typed_number(text.substr(colon + 1)) : std::nullopt;
    if (sizes.size() != 3 || (colon < text.size() && !lid))
        return not_what_it_takes("--case", say("takes.case", {{"example", "425x284x155:45"}}), text);
    options.name.clear();
    options.inside_mm = Vec3d{sizes[2], sizes[1], sizes[0]};
    options.lid_mm = lid;
    options.divisor = CaseOptions{}.divisor;
    return {};
}

std::optional<std::string> say_sizes(const CaseOptions& options) {
    if (!options.inside_mm || !options.name.empty()) return {};
    const auto& [height, width, length] = *options.inside_mm;
    return exact({length, width, height}, 'x') + (options.lid_mm ? ":" + exact(*options.lid_mm) : "");
}

/// What is wrong with the case beyond each size by itself.
std::optional<OptionProblem> problem_of_inside(const CaseOptions& options, Vec3d inside) {
    const double least = std::min({inside.x, inside.y, inside.z});
    if (least <= 2 * options.play_mm)
        return OptionProblem{"play_mm",
                             say("case.no_inside", {{"inside", dimensions({inside.z, inside.y, inside.x})},
                                                    {"play", mm(options.play_mm)}})};
    if (options.lid_mm && *options.lid_mm >= inside.x)
        return OptionProblem{"lid_mm",
                             say("case.lid", {{"height", mm(inside.x)}, {"lid", mm(*options.lid_mm)}})};
    if (options.top_mm && options.lid_mm.value_or(0) <= 0)
        return OptionProblem{"top_mm", say("case.top_without_lid")};
    double narrowest = std::min(inside.y, inside.z);
    for (const auto& section : {options.base_mm, options.top_mm})
        if (section) narrowest = std::min({narrowest, section->width, section->length});
    if (options.base_mm)
        if (auto problem = problem_of_taper(*options.base_mm, inside, options.play_mm, say("case.at_floor")))
            return OptionProblem{"base_mm", *problem};
    if (options.top_mm)
        if (auto problem = problem_of_taper(*options.top_mm, inside, options.play_mm, say("case.at_roof")))
            return OptionProblem{"top_mm", *problem};
    if (!within(options.corner_radius_mm, 0, narrowest / 2))
        return OptionProblem{
            "corner_radius_mm",
            say("case.radius", {{"most", mm(narrowest / 2)}, {"found", mm(options.corner_radius_mm)}})};
    return {};
}

}  // namespace

SharedFlag<CaseOptions> case_size_flag() {
    return {
        .flag = "--case",
        .takes = "LxWxH[:LID]|NAME",
        .help = {"Fill a case: its inside in mm and, after a colon, what of the height belongs to the lid; "
                 "or a name from `snug cases`. The length lies along z, the width along y, the height "
                 "along x",
                 "ケースを満たします：内寸（mm）と、コロンの後に高さのうちふたの分、または `snug cases` "
                 "にある名前。長さは z、幅は y、高さは x の方向です"},
        .take = take_sizes,
        .say = say_sizes};
}

std::optional<OptionProblem> problem_of(const CaseOptions& options) {
    if (auto found = out_of_range(options)) return found;
    return options.inside_mm ? problem_of_inside(options, *options.inside_mm) : std::nullopt;
}

}  // namespace snug
