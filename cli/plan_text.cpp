#include "cli/plan_text.h"

#include <algorithm>
#include <utility>

#include "snug/base/one_line.h"
#include "snug/base/text.h"
#include "snug/check/protection_report.h"
#include "snug/design/presets.h"

#include "cli/wrapped.h"

namespace snug::cli {
namespace {

constexpr std::size_t kMostFindings = 3, kLabel = 10;

using Line = std::pair<std::string, std::string>;

Message kind_text(ProposalKind kind) {
    constexpr const char* kKinds[] = {"plan.kind/smallest", "plan.kind/most-margin", "plan.kind/cheapest"};
    return say(kKinds[static_cast<std::size_t>(kind)]);
}

Message foam_text(const Design& design, Language language) {
    const auto preset = find_preset(built_in_presets(), design.space.preset);
    const Message blocks = as_it_is(preset ? title_of(*preset, language) : design.space.preset);
    if (!design.protection.foam || design.protection.foam->curve.empty()) return blocks;
    return say("plan.foam_of", {{"preset", blocks}, {"foam", design.protection.foam->name}});
}

Message case_text(const Proposal& proposal) {
    const ProposalFigures& f = proposal.figures;
    const std::string& name = proposal.project.design.case_options.name;
    const std::string size = dimensions(f.size_mm, 0), litres = number(f.litres, 1);
    if (!name.empty()) return say("plan.case_known", {{"name", name}, {"size", size}, {"litres", litres}});
    if (proposal.project.design.case_options.inside_mm)
        return say("plan.case_given", {{"size", size}, {"litres", litres}});
    return say("plan.case_made", {{"size", size}, {"litres", litres}});
}

Message cost_text(const Proposal& proposal) {
    const ProposalFigures& f = proposal.figures;
    const std::string &currency = proposal.project.design.workshop.currency, kg = number(f.billed_kg, 1);
    if (!f.cost) return say("plan.billed", {{"kg", kg}});
    return say("plan.money",
               {{"cost", number(*f.cost, 2) + (currency.empty() ? "" : " " + currency)}, {"kg", kg}});
}

Message drop_text(const Proposal& proposal) {
    const ProposalFigures& f = proposal.figures;
    const Design& design = proposal.project.design;
    if (!design.protection.drops()) return say("plan.drop_none");
    if (!mass_kg(design)) return say("plan.drop_no_mass");
    if (!design.protection.foam || design.protection.foam->curve.empty()) return say("plan.drop_no_data");
    if (f.why_none == NoShock::bottoms) return say("plan.drop_bottoms");
    if (!f.worst_g) return say("plan.drop_untold");
    const std::string worst = number(*f.worst_g, 0);
    if (!f.asked_g) return say("plan.drop_alone", {{"worst", worst}});
    return f.meets == Meets::yes
               ? say("plan.drop_meets", {{"worst", worst}, {"asked", number(*f.asked_g, 0)}})
               : say("plan.drop_above", {{"worst", worst}, {"asked", number(*f.asked_g, 0)}});
}

Message walls_text(const ProposalFigures& f) {
    const auto [least, most] = std::minmax_element(f.wall_mm.begin(), f.wall_mm.end());
    const std::string thinnest = number(*least, 0), thickest = number(*most, 0);
    if (thinnest == thickest) return say("plan.walls_same", {{"mm", thinnest}});
    return say("plan.walls_of", {{"thinnest", thinnest}, {"thickest", thickest}});
}

Message work_text(const ProposalFigures& f) {
    return say(
        "plan.work_of",
        {{"pieces", f.pieces}, {"hours", number(f.work_hours(), 1)}, {"seconds", number(f.seconds_each, 1)}});
}

std::string make_text(const Proposal& proposal, const PlanPlaces& places, Language language) {
    const std::string project =
        (std::filesystem::path(*places.folder) / (std::string(name_of(proposal.kind)) + ".snug.json"))
            .string();
    const std::string object =
        places.objects.size() == 1 ? places.objects.front().string() : text(say("plan.folder"), language);
    return "snug make " + project + " --object " + object + " -o " + std::string(name_of(proposal.kind));
}

std::vector<Line> lines_of(const Proposal& proposal, Language language) {
    const auto say_it = [&](const Message& message) { return text(message, language); };
    const ProposalFigures& f = proposal.figures;
    std::vector<Line> lines{{say_it(say("plan.foam")), say_it(foam_text(proposal.project.design, language))},
                            {"", say_it(walls_text(f))},
                            {say_it(say("plan.case")), say_it(case_text(proposal))},
                            {say_it(say("plan.costs")), say_it(cost_text(proposal))},
                            {say_it(say("plan.drop")), say_it(drop_text(proposal))},
                            {say_it(say("plan.work")), say_it(work_text(f))}};
    std::size_t told = 0;
    for (const Finding& finding : proposal.findings) {
        if (finding.severity == Severity::note || told++ == kMostFindings) break;
        const char* code = finding.severity == Severity::danger ? "inspect.danger" : "inspect.warning";
        lines.emplace_back(say_it(say(code)), say_it(said_of_item(finding)));
    }
    return lines;
}

}  // namespace

std::string plan_text(std::span<const Proposal> proposals, const PlanPlaces& places, Language language) {
    std::string all;
    for (std::size_t i = 0; i < proposals.size(); ++i) {
        const Proposal& proposal = proposals[i];
        all += text(kind_text(proposal.kind), language);
        const auto same =
            std::find_if(proposals.begin(), proposals.begin() + static_cast<std::ptrdiff_t>(i),
                         [&](const Proposal& other) { return other.project == proposal.project; });
        if (same != proposals.begin() + static_cast<std::ptrdiff_t>(i)) {
            all += ": " + text(say("plan.same", {{"other", kind_text(same->kind)}}), language) + "\n";
            continue;
        }
        all += "\n";
        for (const auto& [label, value] : lines_of(proposal, language))
            all += "  " + padded(label, kLabel) + wrapped(one_line(value), kLabel + 2) + "\n";
        if (places.folder)
            all += "  " + padded(text(say("plan.make"), language), kLabel) +
                   make_text(proposal, places, language) + "\n";
    }
    if (places.folder) all += text(say("plan.written", {{"folder", *places.folder}}), language) + "\n";
    return all;
}

}  // namespace snug::cli
