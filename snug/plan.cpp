#include "snug/plan.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <tuple>
#include <utility>

#include <nlohmann/json.hpp>

#include "snug/fabricate/kit/json_values.h"
#include "snug/fabricate/kit/output_files.h"
#include "snug/fabricate/kit/work_time.h"
#include "snug/search/rank_cases.h"
#include "snug/search/shock_wishes.h"

namespace snug {
namespace {

/// A design that was made: what is told of it, and what it is compared by.
struct Tried {
    Proposal proposal;
    bool has_data = false;  ///< of how its foam pushes back

    [[nodiscard]] const ProposalFigures& figures() const { return proposal.figures; }
};

Vec3d outside_mm(const Packing& packing, const Design& design) {
    if (design.case_options.inside_mm) return *design.case_options.inside_mm;
    return packing.space.size();
}

const KnownCase* case_of(const Design& design, const PlanWishes& wishes) {
    for (const KnownCase& known : wishes.cases)
        if (design.case_options.inside_mm && known.name == design.case_options.name) return &known;
    return nullptr;
}

/// What stands in the way of any figure, whatever the foam does.
bool says_nothing(NoShock why) {
    return why == NoShock::no_foam_data || why == NoShock::no_mass || why == NoShock::no_height ||
           why == NoShock::open;
}

/// Of the side and item that are worst off: one without a figure is worse than any that has one.
void put_shocks(const Protection& protection, ProposalFigures& figures) {
    const ItemProtection* item = nullptr;
    const FaceShock* face = nullptr;
    for (const ItemProtection& each : protection.items)
        for (int side = 0; side < 6; ++side)
            if (const double found = margin(each, static_cast<Side>(side)); !face || found > figures.margin) {
                item = &each;
                face = &each.faces[static_cast<std::size_t>(side)];
                figures.margin = found;
            }
    figures.worst_g = face->g_high;
    figures.asked_g = item->asked_g;
    figures.why_none = face->g_high ? NoShock::none : face->bottoms ? NoShock::bottoms : face->why_none;
    if (says_nothing(figures.why_none)) return;
    if (figures.asked_g)
        figures.meets = figures.worst_g && *figures.worst_g <= *figures.asked_g ? Meets::yes : Meets::no;
    else if (figures.why_none == NoShock::bottoms)
        figures.meets = Meets::no;
}

/// What nothing is claimed of is met where no drop is looked at.
Meets without_drops(const Design& design) {
    return design.protection.drops() ? Meets::unknown : Meets::yes;
}

std::optional<double> gross_kg(const Design& design, const Made& made, const KnownCase* known) {
    const auto items = mass_kg(design);
    if (!items) return {};
    const double foam = made.pack ? made.pack->material.foam_kg.value_or(0) : 0;
    return *items + foam + (known ? known->tare_kg.value_or(0) : 0);
}

double billed(const ProposalFigures& figures, const Design& design, const KnownCase* known) {
    KnownCase billed = known ? *known : KnownCase();
    billed.inside_mm = figures.size_mm;
    billed.tare_kg.reset();  // it is in the gross mass
    return billed_kg(billed, {{}, figures.gross_kg, design.search.billed_divisor}).value_or(0);
}

std::optional<double> cost_of(const Made& made, const KnownCase* known) {
    const auto material = made.pack ? made.pack->material.cost : std::nullopt;
    const auto price = known ? known->price : std::nullopt;
    if (!material && !price) return {};
    return material.value_or(0) + price.value_or(0);
}

ProposalFigures figures_of(const Made& made, const Design& design, const PlanWishes& wishes) {
    ProposalFigures figures;
    const KnownCase* known = case_of(design, wishes);
    figures.size_mm = outside_mm(made.packing, design);
    figures.litres = figures.size_mm.x * figures.size_mm.y * figures.size_mm.z * 1e-6;
    figures.gross_kg = gross_kg(design, made, known);
    figures.billed_kg = billed(figures, design, known);
    figures.cost = cost_of(made, known);
    figures.meets = without_drops(design);
    if (made.packing.protection) put_shocks(*made.packing.protection, figures);
    if (made.pack) figures.pieces = made.pack->material.pieces.value_or(0);
    figures.seconds_each = wishes.seconds_each.value_or(seconds_each(design.workshop.work));
    figures.wall_mm.assign(made.packing.fit.wall_mm.begin(), made.packing.fit.wall_mm.end());
    return figures;
}

bool has_danger(const std::vector<Finding>& findings) {
    return !findings.empty() && findings.front().severity == Severity::danger;
}

/// Those that do what was asked first; what has a danger beside it last of its kind.
int rank_of(const Tried& tried) {
    return 2 * static_cast<int>(tried.figures().meets == Meets::yes       ? 0
                                : tried.figures().meets == Meets::unknown ? 1
                                                                          : 2) +
           (has_danger(tried.proposal.findings) ? 1 : 0);
}

using Key = std::tuple<int, double, double, double>;

Key smallest_key(const Tried& tried) {
    const ProposalFigures& f = tried.figures();
    return {rank_of(tried), f.litres, f.billed_kg, f.work_hours()};
}

/// Where no shock is known the thinnest foam stands for it.
Key margin_key(const Tried& tried) {
    const ProposalFigures& f = tried.figures();
    const double thinnest = *std::min_element(f.wall_mm.begin(), f.wall_mm.end());
    if (!tried.has_data)
        return {has_danger(tried.proposal.findings) ? 3 : 2, -thinnest, f.litres, f.billed_kg};
    // Of foams that are pressed flat the thicker one is nearer to what is asked.
    const double next = f.why_none == NoShock::bottoms ? -thinnest : f.litres;
    return {has_danger(tried.proposal.findings) ? 1 : 0, f.margin, next, f.billed_kg};
}

/// `priced`: where every cost is known money decides, else the billed weight.
Key cheapest_key(const Tried& tried, bool priced) {
    const ProposalFigures& f = tried.figures();
    return {rank_of(tried), priced ? *f.cost : f.billed_kg, f.work_hours(), f.litres};
}

template <class KeyOf>
const Tried& least(const std::vector<Tried>& all, const KeyOf& key) {
    return *std::min_element(all.begin(), all.end(),
                             [&](const Tried& a, const Tried& b) { return key(a) < key(b); });
}

bool has(std::string_view code, const std::vector<Finding>& findings) {
    return std::any_of(findings.begin(), findings.end(),
                       [&](const Finding& finding) { return finding.code() == code; });
}

/// Where nobody asked for settling and nothing came down, the design does without it: but where foam does
/// not bear, since that is told with advice to settle where it was not tried.
void drop_idle_settling(const Project& asked, const Made& made, Proposal& proposal) {
    const std::vector<Item>& items = made.packing.items;
    if (asked.design.fit.settle || has("no_bearing", proposal.findings) ||
        std::any_of(items.begin(), items.end(), [](const Item& item) { return item.settled_mm != 0; }))
        return;
    proposal.project.design.fit.settle = false;
    std::erase_if(proposal.findings, [](const Finding& finding) { return finding.code() == "settled_none"; });
}

Result<Tried> tried(std::span<Object> objects, const Project& project, const Design& planned,
                    const PlanWishes& wishes, const Tools& tools) {
    Tried all;
    Proposal& proposal = all.proposal;
    proposal.project = project;
    proposal.project.design = planned;
    auto made = make(objects, proposal.project, tools);
    if (!made) return tl::unexpected(made.error());
    if (!made->packing.foams)
        return fail(ErrorKind::does_not_fit, said_of_item(made->packing.findings.front()));
    const Design& design = proposal.project.design;
    proposal.figures = figures_of(*made, design, wishes);
    proposal.findings = made->packing.findings;
    drop_idle_settling(project, *made, proposal);
    proposal.preview_svg = preview_of(objects, proposal.project, *made);
    const auto& foam = design.protection.foam;
    all.has_data = foam && !foam->curve.empty() && !says_nothing(proposal.figures.why_none);
    return all;
}

std::vector<Proposal> chosen(const std::vector<Tried>& all) {
    const bool priced = std::all_of(all.begin(), all.end(),
                                    [](const Tried& each) { return each.figures().cost.has_value(); });
    const auto cheapest = [&](const Tried& each) { return cheapest_key(each, priced); };
    std::vector<Proposal> proposals{least(all, smallest_key).proposal, least(all, margin_key).proposal,
                                    least(all, cheapest).proposal};
    for (std::size_t i = 0; i < proposals.size(); ++i) proposals[i].kind = static_cast<ProposalKind>(i);
    return proposals;
}

nlohmann::ordered_json proposal_json(const Proposal& proposal, Language language) {
    using Json = nlohmann::ordered_json;
    const Design& design = proposal.project.design;
    const ProposalFigures& f = proposal.figures;
    Json findings = Json::array(), walls = Json::array();
    for (const Finding& finding : proposal.findings)
        findings.push_back({{"code", finding.code()},
                            {"severity", severity_name(finding.severity)},
                            {"message", text(said_of_item(finding), language)}});
    for (const double wall : f.wall_mm) walls.push_back(rounded(wall));
    const auto or_nothing = [](const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); };
    return {{"kind", name_of(proposal.kind)},
            {"for", name_of(design.workshop.work)},
            {"preset", or_nothing(design.space.preset)},
            {"foam", design.protection.foam ? Json(design.protection.foam->name) : Json(nullptr)},
            {"case", or_nothing(design.case_options.name)},
            {"size_mm", array(f.size_mm)},
            {"litres", rounded(f.litres)},
            {"gross_kg", or_null(f.gross_kg, 1e3)},
            {"billed_kg", f.billed_kg},
            {"cost", or_null(f.cost, 1e2)},
            {"currency", or_nothing(design.workshop.currency)},
            {"worst_g", or_null(f.worst_g, 10)},
            {"asked_g", or_null(f.asked_g, 10)},
            {"why_none", or_nothing(std::string(name_of(f.why_none)))},
            {"meets", name_of(f.meets)},
            {"pieces", f.pieces},
            {"seconds_each", f.seconds_each},
            {"work_hours", rounded(f.work_hours())},
            {"wall_mm", walls},
            {"findings", findings}};
}

}  // namespace

Result<std::vector<Proposal>> plan(std::span<Object> objects, const Project& project,
                                   const PlanWishes& wishes, const Tools& tools, const Progress& progress) {
    Project asked = project;
    take_over_one_item(asked);
    expect_drops(wishes.carrier, asked.design);
    const PackIt pack_it = [&](const Design& design) { return pack(objects, design); };
    const auto designs = planned_designs(objects, asked.design, wishes, pack_it, part_of(progress, 0, 0.7));
    if (!designs) return tl::unexpected(designs.error());
    std::vector<Tried> all;
    std::optional<Error> why_not;
    for (std::size_t i = 0; i < designs->size(); ++i) {
        const double done = static_cast<double>(i) / static_cast<double>(designs->size());
        if (!go_on(progress, 0.7 + 0.3 * done)) return fail(ErrorKind::cancelled, say("cancelled"));
        auto one = tried(objects, asked, (*designs)[i], wishes, tools);
        if (one)
            all.push_back(std::move(*one));
        else if (!why_not)
            why_not = one.error();
    }
    if (all.empty()) return tl::unexpected(*why_not);
    return chosen(all);
}

std::string plan_json(std::span<const Proposal> proposals, Language language) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const Proposal& proposal : proposals) json.push_back(proposal_json(proposal, language));
    return json.dump(2) + "\n";
}

}  // namespace snug
