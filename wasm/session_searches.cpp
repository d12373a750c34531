#include <cstdint>
#include <optional>
#include <utility>

#include "snug/base/stopwatch.h"
#include "snug/design/known_foams.h"
#include "snug/make.h"
#include "snug/object/prepare.h"
#include "snug/plan.h"
#include "snug/search/search_design.h"
#include "snug/search/searched_zones.h"

#include "wasm/session.h"
#include "wasm/values.h"

// Searches that the page steps, and shows while they run.

namespace snug::wasm {
namespace {

/// The same placements for the same object, whenever it is searched.
constexpr std::uint64_t kSearchSeed = 1;
/// Between two looks at what the page says.
constexpr double kStepMs = 60;
constexpr std::size_t kMostDistinct = 6;

/// Words that none of the page's choices has are passed over.
PlanWishes wishes_from(const val& wishes) {
    PlanWishes result;
    result.carrier = value_named<Carrier>(wishes["carrier"].as<std::string>()).value_or(result.carrier);
    result.ways.clear();
    for (const std::string& word : emscripten::vecFromJSArray<std::string>(wishes["ways"]))
        if (const auto way = value_named<Workshop>(word); way && *way != Workshop::none)
            result.ways.push_back(*way);
    if (result.ways.empty()) result.ways = PlanWishes().ways;
    const auto choice = value_named<CaseChoice>(wishes["cases"].as<std::string>());
    choose_cases(built_in_cases(), choice.value_or(CaseChoice::none), result);
    result.own_blocks = wishes["own_blocks"].as<bool>();
    result.foams = built_in_foams();
    return result;
}

}  // namespace

Result<Session::SearchedOne> Session::begin_with_one(const std::string& design_text, const val& objects) {
    auto project = lay_out_one(design_text, objects);
    if (!project) return tl::unexpected(project.error());
    Object& object = store_.objects().front();
    prepare_for_many(object);
    auto packing = snug::pack(object, project->design);
    if (!packing) return tl::unexpected(packing.error());
    auto zones = searched_zones(object, project->design);
    if (!zones) return tl::unexpected(zones.error());
    return SearchedOne{std::move(project->design), std::move(*packing), std::move(*zones)};
}

val Session::start_search(const std::string& design_text, const val& objects) {
    auto begun = begin_with_one(design_text, objects);
    if (!begun) return to_val(begun.error());
    const Object& object = store_.objects().front();
    const DesignSpace& space = begun->packing.space;
    std::optional<ShockMargins> shocks;
    if (begun->design.search.weighs(Objective::shock)) {
        const auto pack_it = [&object](const Design& tried) { return snug::pack(object, tried); };
        auto started = ShockMargins::start(object, begun->design, space, pack_it);
        if (!started) return to_val(started.error());
        shocks = std::move(*started);
    }
    auto search =
        PlacementSearch::start(object.mesh, *object.prepared, begun->design, space, kSearchSeed,
                               begun->packing.available, std::move(begun->zones), std::move(shocks));
    if (!search) return to_val(search.error());
    search_ = std::move(*search);
    searched_ = space;
    return to_val(*search_, searched_);
}

val Session::search_step() {
    if (!search_) return to_val(Error{ErrorKind::cancelled, say("session.changed")});
    Stopwatch watch;
    run(*search_, kSearchEvaluations, [spent = 0.0, &watch](const PlacementSearch&) mutable {
        spent += watch.lap();
        return spent < kStepMs;
    });
    return to_val(*search_, searched_);
}

val Session::distinct() const {
    val list = val::array();
    if (search_)
        for (const FoundPlacement& placement : search_->distinct(kMostDistinct))
            list.call<void>("push", to_val(placement));
    return list;
}

val Session::plan(const std::string& design_text, const val& objects, const val& wishes,
                  const std::string& language, const val& progress) {
    const auto project = lay_out(design_text, objects);
    if (!project) return to_val(project.error());
    for (Object& object : store_.objects()) prepare_for_many(object);
    Tools tools;
    tools.language = language_of(language);
    const auto proposals =
        snug::plan(store_.objects(), *project, wishes_from(wishes), tools, progress_from(progress));
    if (!proposals) return to_val(proposals.error());
    val result = val::object(), designs = val::array(), previews = val::array();
    for (const Proposal& proposal : *proposals) {
        designs.call<void>("push", design_json(proposal.project.design));
        previews.call<void>("push", proposal.preview_svg);
    }
    result.set("plan", plan_json(*proposals, tools.language));
    result.set("designs", designs);
    result.set("previews", previews);
    return result;
}

val Session::start_map(const std::string& design_text, const val& objects) {
    auto begun = begin_with_one(design_text, objects);
    if (!begun) return to_val(begun.error());
    const Object& object = store_.objects().front();
    map_.emplace(object.mesh, *object.prepared, begun->design, begun->packing.space, kMapDirections,
                 begun->packing.available, std::move(begun->zones));
    return to_val(*map_);
}

val Session::map_step() {
    if (!map_) return to_val(Error{ErrorKind::cancelled, say("session.changed")});
    Stopwatch watch;
    for (double spent = 0; spent < kStepMs && map_->passes() < kMapPasses; spent += watch.lap()) map_->step();
    return to_val(*map_);
}

}  // namespace snug::wasm
