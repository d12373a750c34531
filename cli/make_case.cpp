#include "cli/make_case.h"

#include <string_view>

#include <fmt/core.h>

#include "snug/base/text.h"
#include "snug/words/halves.h"
#include "snug/words/sides.h"
#include "snug/words/words.h"

#include "cli/option_values.h"
#include "cli/user_cases.h"

namespace snug::cli {
namespace {

/// Whether the text is meant as sizes ("425x284x155:45"), not as a name.
bool looks_like_sizes(std::string_view text) {
    return text.find('x') != std::string_view::npos &&
           text.find_first_not_of("0123456789.+-x:") == std::string_view::npos;
}

Result<void> take_sizes(const std::string& text, CaseOptions& options) {
    const std::size_t colon = text.find(':');
    const auto sizes = parse_sizes("--case", text.substr(0, colon));
    if (!sizes)
        return fail(ErrorKind::usage,
                    fmt::format("--case takes length, width and height inside in mm, with the lid's part of "
                                "the height if it is known, such as 425x284x155:45, or a name that `snug "
                                "cases` lists, not {}",
                                snug::quoted(text)));
    options.name.clear();
    options.inside_mm = Vec3d{sizes->z, sizes->y, sizes->x};
    options.lid_mm.reset();
    options.divisor = CaseOptions{}.divisor;
    if (colon == std::string::npos) return {};
    const auto lid = parse_length("--case", text.substr(colon + 1));
    if (!lid) return tl::unexpected(lid.error());
    options.lid_mm = *lid;
    return {};
}

Result<void> take_section(const char* option, const std::optional<std::string>& text,
                          std::optional<CrossSection>& section) {
    if (!text) return {};
    // Read as three sizes, of which the last is not used.
    const auto sizes = parse_sizes(option, *text + "x0");
    if (!sizes)
        return fail(ErrorKind::usage, fmt::format("{} takes length and width in mm such as 410x270, not {}",
                                                  option, snug::quoted(*text)));
    section = CrossSection{sizes->y, sizes->x};
    return {};
}

/// "410 x 278 x 12 mm"
std::string size_text(Vec3d size) {
    return dimensions({size.z, size.y, size.x}) + " mm";
}

}  // namespace

void add_case_options(CLI::App& command, CaseArguments& a) {
    command
        .add_option(
            "--case", a.size_or_name,
            "Fill a case: its inside in mm and, after a colon, what of the height belongs to the lid; "
            "or a name from `snug cases`. The length lies along z, the width along y, the height along x")
        ->type_name("LxWxH[:LID]|NAME");
    command.add_option("--case-play", a.play, "Air between foam and case on each side (3)")->type_name("MM");
    command.add_option("--case-radius", a.radius, "Radius of the case's upright edges (0)")->type_name("MM");
    command.add_option("--case-base", a.base, "Inside at the floor, where the walls lean")->type_name("LxW");
    command.add_option("--case-top", a.top, "Inside at the roof of the lid, where its walls lean")
        ->type_name("LxW");
}

Result<void> take_case(const CaseArguments& a, bool with_blocks, Design& design) {
    CaseOptions& options = design.case_options;
    if (a.size_or_name && with_blocks)
        return fail(ErrorKind::usage,
                    "--case and --blocks exclude each other: the case decides how many blocks go in");
    if (with_blocks) options.inside_mm.reset();
    if (a.size_or_name && looks_like_sizes(*a.size_or_name)) {
        if (auto done = take_sizes(*a.size_or_name, options); !done) return done;
    } else if (a.size_or_name) {
        const auto cases = known_cases();
        if (!cases) return tl::unexpected(cases.error());
        const auto known = find_case(*cases, *a.size_or_name);
        if (!known) return fail(ErrorKind::usage, in_file("--case", known.error().message));
        apply(*known, options);
    }
    if (a.play) options.play_mm = *a.play;
    if (a.radius) options.corner_radius_mm = *a.radius;
    if (auto done = take_section("--case-base", a.base, options.base_mm); !done) return done;
    if (auto done = take_section("--case-top", a.top, options.top_mm); !done) return done;
    if (!options.inside_mm && (a.play || a.radius || a.base || a.top))
        return fail(ErrorKind::usage,
                    "--case-play, --case-radius, --case-base and --case-top belong to --case LxWxH[:LID]");
    return {};
}

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
