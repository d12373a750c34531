#include "snug/design/workshop_options.h"

#include <algorithm>
#include <array>

#include "snug/base/text.h"

namespace snug {
namespace {

struct Way {
    Workshop work;
    std::string_view name, preset;
};
constexpr std::array<Way, 6> kWays{{{Workshop::sponge, "sponge", "slit-15"},
                                    {Workshop::sheets, "sheets", "sheet-10"},
                                    {Workshop::print, "print", "print"},
                                    {Workshop::bricks, "bricks", "lego-brick"},
                                    {Workshop::mill, "mill", "mill"},
                                    {Workshop::mould, "mould", "cast"}}};
struct Paper {
    std::string_view name;
    Vec2d mm;
};
constexpr std::array<Paper, 3> kPapers{{{"a4", {210, 297}}, {"letter", {215.9, 279.4}}, {"a3", {297, 420}}}};
constexpr double kMost = 1e6;  // of any price, mass or density
constexpr std::size_t kLongestCurrency = 12;

const Way* way(Workshop workshop) {
    const auto found =
        std::find_if(kWays.begin(), kWays.end(), [&](const Way& each) { return each.work == workshop; });
    return found == kWays.end() ? nullptr : found;
}

const Paper* paper_of(std::string_view name) {
    const auto found =
        std::find_if(kPapers.begin(), kPapers.end(), [&](const Paper& each) { return each.name == name; });
    return found == kPapers.end() ? nullptr : found;
}

bool positive(const std::optional<double>& value) {
    return !value || (*value > 0 && *value <= kMost);
}

}  // namespace

std::string_view workshop_name(Workshop workshop) {
    const Way* found = way(workshop);
    return found ? found->name : std::string_view();
}

std::optional<Workshop> workshop_from_name(std::string_view name) {
    for (const Way& each : kWays)
        if (each.name == name) return each.work;
    return {};
}

std::string workshop_names() {
    std::string names;
    for (const Way& each : kWays)
        names += (names.empty()                    ? ""
                  : each.work == kWays.back().work ? " or "
                                                   : ", ") +
                 std::string(each.name);
    return names;
}

std::string unknown_workshop(std::string_view name) {
    return "unknown pack " + quoted(name) + ": take " + workshop_names();
}

std::string_view usual_preset(Workshop workshop) {
    const Way* found = way(workshop);
    return found ? found->preset : std::string_view("paper");
}

Vec2d paper_mm(std::string_view paper) {
    const Paper* found = paper_of(paper);
    return found ? found->mm : kPapers.front().mm;
}

std::optional<std::string> problem_of(const WorkshopOptions& options) {
    if (!paper_of(options.paper)) return "the paper must be a4, letter or a3, not " + quoted(options.paper);
    if (options.price_per_litre && !(*options.price_per_litre >= 0 && *options.price_per_litre <= kMost))
        return "the price of a litre must be a number from 0 up, not " + number(*options.price_per_litre, 4);
    if (options.currency.size() > kLongestCurrency)
        return "the currency must be a short word such as EUR, not " + quoted(options.currency);
    if (!positive(options.mass_kg))
        return "the object's mass must be a number of kilograms above 0, not " + number(*options.mass_kg, 4);
    if (!positive(options.density_kg_m3))
        return "the density must be a number of kg/m3 above 0, not " + number(*options.density_kg_m3, 4);
    if (auto found = problem_of(options.sheets)) return found;
    if (auto found = problem_of(options.print)) return found;
    if (auto found = problem_of(options.bricks)) return found;
    if (auto found = problem_of(options.mill)) return found;
    return problem_of(options.mould);
}

}  // namespace snug
