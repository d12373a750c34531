#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "snug/base/finding.h"
#include "snug/design/project.h"
#include "snug/make.h"
#include "snug/search/plan_designs.h"

// From what people know of their thing to whole proposals: three designs, each packed, dropped and made ready
// for the workshop as make() does, so that every figure is that of what they would get.

namespace snug {

enum class ProposalKind {
    smallest,     ///< least room outside
    most_margin,  ///< least met in a drop for what the items bear, among foams with data
    cheapest,     ///< least money where prices are known, else least billed weight; then least work
};
template <>
struct Names<ProposalKind> {
    static constexpr std::string_view list[] = {"smallest", "most-margin", "cheapest"};
};

/// Whether it does what was asked.
enum class Meets { yes, no, unknown };
template <>
struct Names<Meets> {
    static constexpr std::string_view list[] = {"yes", "no", "unknown"};
};

struct ProposalFigures {
    Vec3d size_mm;      ///< of the foam, or inside the case that holds it: height, width, length
    double litres = 0;  ///< of that
    std::optional<double>
        gross_kg;                ///< items, foam and case, as far as they are known; none: a mass is missing
    double billed_kg = 0;        ///< the greater of the mass and the volumetric weight, whole kg
    std::optional<double> cost;  ///< of material and case; none: no price is known
    std::optional<double> worst_g;     ///< the high end on the worst side; none: nothing is claimed of drops
    NoShock why_none = NoShock::none;  ///< why there is none, though drops are looked at
    std::optional<double> asked_g;     ///< of the item that it is of
    double margin = 0;                 ///< worst_g / asked_g, see margin(); kNoMargin and more: no G
    Meets meets = Meets::unknown;
    long long pieces = 0;         ///< to be handled one by one
    double seconds_each = 0;      ///< of work for each of them
    std::vector<double> wall_mm;  ///< by Side

    [[nodiscard]] double work_hours() const { return static_cast<double>(pieces) * seconds_each / 3600; }
};

struct Proposal {
    ProposalKind kind{};
    Project project;
    ProposalFigures figures;
    std::vector<Finding> findings;  ///< dangers first
    std::string preview_svg;
};

/// One of each kind, in their order; what is best in two ways stands twice. Those that do what was asked come
/// first, then those of which it is not known. `objects`: of the project's items, prepared for many. Fails as
/// planned_designs() does, and with the first reason where nothing could be made.
[[nodiscard]] Result<std::vector<Proposal>> plan(std::span<Object> objects, const Project& project,
                                                 const PlanWishes& wishes, const Tools& tools = {},
                                                 const Progress& progress = {});

/// What is told of the proposals: an array of {kind, for, preset, foam, case, size_mm, litres, gross_kg,
/// billed_kg, cost, currency, worst_g, asked_g, why_none, meets, pieces, seconds_each, work_hours, wall_mm,
/// findings
/// [{code, severity, message}]}. Messages in the language.
[[nodiscard]] std::string plan_json(std::span<const Proposal> proposals, Language language);

}  // namespace snug
