#include "wasm/session.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "snug/base/stopwatch.h"
#include "snug/check/contact_map.h"
#include "snug/check/find_pads.h"
#include "snug/check/find_relief.h"
#include "snug/check/protection.h"
#include "snug/design/options_schema.h"
#include "snug/formats/read_object.h"
#include "snug/make.h"
#include "snug/search/protecting_walls.h"
#include "snug/search/rank_cases.h"
#include "snug/search/search_design.h"
#include "snug/space/place_items.h"

#include "wasm/arrangements.h"
#include "wasm/fit_values.h"
#include "wasm/projects.h"
#include "wasm/protection_values.h"
#include "wasm/scene_tools.h"
#include "wasm/workshop_values.h"
#include "wasm/zone_values.h"

namespace snug::wasm {
namespace {

const Error kNoObject{ErrorKind::usage, say("session.no_object")};
const Error kNotOfClouds{ErrorKind::usage, say("session.cloud")};
const Error kNoFoams{ErrorKind::usage, say("session.no_foams")};

std::vector<int> numbers_from(const val& list) {
    std::vector<int> numbers(list["length"].as<std::size_t>());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = list[i].as<int>();
    return numbers;
}

/// Cases that hold several items as they lie: they are not turned together.
CaseRanking as_they_lie(CaseRanking ranking) {
    const auto turned = [](const RankedCase& each) { return each.lay != kLays.front(); };
    ranking.fitting.erase(std::remove_if(ranking.fitting.begin(), ranking.fitting.end(), turned),
                          ranking.fitting.end());
    if (ranking.nearest && turned(*ranking.nearest)) ranking.nearest.reset();
    return ranking;
}

/// drops() tells of them.
bool tells_drops(const Design& design) {
    return design.protection.drops() || design.protection.foam;
}

/// Of pads and reliefs, as make() finds it once its drops were looked at, or are not asked for.
void find_fitting(const Packing& packing, const Design& design, std::vector<Finding>& findings) {
    find_relief(packing, design, findings);
    if (design.fit.pads) find_pads(packing, *design.fit.pads, findings);
}

}  // namespace

val make_files(std::span<Object> objects, Project project, Language language, const Progress& progress) {
    Tools tools;
    tools.language = language;
    tools.progress = [&progress](Stage stage) { return stage == Stage::gaps ? progress : Progress(); };
    auto made = make(objects, project, tools);
    if (!made) return to_val(made.error());
    if (!made->packing.foams)
        return to_val(Error{ErrorKind::does_not_fit, made->packing.findings.front().message});
    val result = val::object();
    val files = val::array();
    const auto take = [&files](const PackFile& file) -> Result<void> {
        files.call<void>("push", to_val(file));
        return {};
    };
    if (auto done = make_output_files(objects, project, *made, take); !done) return to_val(done.error());
    result.set("files", files);
    result.set("report", report_json(objects, project, *made));
    if (made->pack) result.set("pack", to_val(*made->pack));
    return result;
}

val Session::load(int number, const val& bytes, const std::string& name, const std::string& design_text,
                  const val& tools) {
    const auto design = parse_design(design_text);
    if (!design) return to_val(design.error());
    auto mesh = read_object(bytes_from(bytes), name, scene_tools_from(tools));
    if (!mesh) return to_val(mesh.error());
    const auto error = store_.load(number, std::move(*mesh), *design);
    const ObjectStore::Entry* const entry = store_.find(number);
    if (!entry) return to_val(*error);
    forget_results();
    if (error) return to_val(unscaled(entry->read), entry->box.size(), error);
    return to_val(store_.object_of(*entry), entry->box.size(), {});
}

void Session::keep(const val& numbers) {
    store_.keep(numbers_from(numbers));
    forget_results();
}

/// What is of objects that are not what they were.
void Session::forget_results() {
    if (edition_ == store_.edition()) return;
    edition_ = store_.edition();
    search_.reset();
    map_.reset();
    packing_.reset();
    protection_.reset();
}

Result<Project> Session::lay_out(const std::string& design, const val& objects) {
    auto project = project_from(design, objects);
    if (!project) return project;
    std::vector<int> numbers;
    for (std::size_t i = 0; i < project->objects.size(); ++i)
        numbers.push_back(objects[i]["number"].as<int>());
    const auto error = store_.lay_out(numbers, *project);
    forget_results();
    if (error) return tl::unexpected(*error);
    return project;
}

/// What searches for one item alone, between foams that close.
Result<Project> Session::lay_out_one(const std::string& design, const val& objects) {
    auto project = lay_out(design, objects);
    if (project && project->design.items.size() > 1)
        return fail(ErrorKind::usage, say("session.one_item", {{"items", project->design.items.size()}}));
    if (project && project->design.space.open) return fail(ErrorKind::usage, say("search.tray"));
    return project;
}

val Session::describe(int number, const std::string& design_text) {
    const auto design = parse_design(design_text);
    if (!design) return to_val(design.error());
    const auto error = store_.prepare(number, *design);
    forget_results();
    const ObjectStore::Entry* const entry = store_.find(number);
    if (!error) return to_val(store_.object_of(*entry), entry->box.size(), {});
    if (!entry || !asks_for_unit(*entry, *design)) return to_val(*error);
    return to_val(unscaled(entry->read), entry->box.size(), error);
}

val Session::mesh(int number) const {
    const ObjectStore::Entry* const entry = store_.find(number);
    if (!entry) return to_val(Mesh{});
    if (!entry->prepared) return to_val(entry->read);
    const Object& object = store_.object_of(*entry);
    val result = to_val(object.mesh);
    result.set("parts", part_numbers(object));
    return result;
}

/// The first packing should be seen at once. After it what changes may change many times: all objects, but
/// where items alone differ in a space that stays as it is, those of the items that do.
void Session::prepare_what_changes(const Design& design) {
    if (!packing_) return;
    const std::vector<ItemOptions>& before = packed_.items;
    Design otherwise = design;
    otherwise.items = before;
    const bool stays = design.space.blocks || design.case_options.inside_mm;
    const bool items_alone = stays && otherwise == packed_ && design.items.size() == before.size();
    for (std::size_t i = 0; i < design.items.size(); ++i) {
        const auto object = static_cast<std::size_t>(design.items[i].object);
        if (object < store_.objects().size() && (!items_alone || !(design.items[i] == before[i])))
            prepare_for_many(store_.objects()[object]);
    }
}

val Session::pack(const std::string& design_text, const val& objects) {
    Stopwatch watch;
    const auto project = lay_out(design_text, objects);
    if (!project) return to_val(project.error());
    const Design& design = project->design;
    prepare_what_changes(design);
    auto packing = snug::pack(store_.objects(), design, {}, &depths_);
    if (!packing) return to_val(packing.error());
    packing_ = std::move(*packing);
    if (packing_->foams && !tells_drops(design)) find_fitting(*packing_, design, packing_->findings);
    protection_.reset();
    packed_ = design;
    val result = to_val(*packing_, watch.lap());
    result.set("dependent", dependent_options(design));
    return result;
}

val Session::gaps(const val& progress) {
    if (!packing_ || !packing_->foams) return to_val(kNoFoams);
    for (const Object& object : store_.objects())
        if (!object.whole()) return to_val(kNotOfClouds);
    Packing packing = *packing_;
    const auto measured = measure_fit(store_.objects(), packing, packed_, progress_from(progress));
    if (!measured) return to_val(measured.error());
    const auto offer = relief_offer();
    if (!offer) return to_val(offer.error());
    val result = to_val(*measured->gap, measured->layer_gaps);
    result.set("relief", relief_val(*offer, packing));
    result.set("bearing", to_val(*measured->bearing, packed_));
    result.set("findings", to_val(packing.findings, packing.items));
    return result;
}

/// Of a copy of the last packing, which gets the findings of drops alone.
Result<Protection> Session::protection_of(Packing& packing) {
    packing = *packing_;
    packing.findings.clear();
    auto found = protection(store_.objects(), packing, packed_);
    if (found) protection_ = *found;
    return found;
}

val Session::drops() {
    if (!packing_ || !packing_->foams) return to_val(kNoFoams);
    Packing packing;
    const auto found = protection_of(packing);
    if (!found) return to_val(found.error());
    packing.protection = *found;
    std::vector<Finding> fitting;
    find_fitting(packing, packed_, fitting);
    return to_val(*found, packing, fitting);
}

/// Takes too long for drops(), which follows sliders.
Result<std::optional<ReliefOffer>> Session::relief_offer() {
    if (!tells_drops(packed_)) return std::nullopt;
    Packing packing;
    auto found = protection_of(packing);
    if (!found) return tl::unexpected(found.error());
    packing.protection = std::move(*found);
    return offered_relief(store_.objects(), packed_, packing);
}

val Session::contacts(const val& side) {
    if (!packing_ || !packing_->foams) return to_val(kNoFoams);
    Packing packing;
    if (!protection_)
        if (const auto found = protection_of(packing); !found) return to_val(found.error());
    std::optional<Side> on;
    if (!side.isNull()) on = static_cast<Side>(std::clamp(side.as<int>(), 0, 5));
    const auto map = contact_map(store_.objects(), *packing_, *protection_, on);
    return map ? contacts_val(*map, *protection_, on) : to_val(map.error());
}

val Session::protecting_walls(const std::string& design, const val& objects, const val& progress) {
    auto project = lay_out(design, objects);
    if (!project) return to_val(project.error());
    for (Object& object : store_.objects()) prepare_for_many(object);
    KeptDepths kept;
    const auto pack_it = [&](const Design& tried) { return snug::pack(store_.objects(), tried, {}, &kept); };
    const auto found =
        snug::protecting_walls(store_.objects(), project->design, pack_it, progress_from(progress));
    if (!found) return to_val(found.error());
    val result = val::object();
    result.set("design", design_json(*found));
    return result;
}

val Session::zones() {
    if (!packing_ || !packing_->foams) return to_val(kNoFoams);
    Packing packing;
    const auto found = protection_of(packing);
    return found ? zones_val(found->zones, packing) : to_val(found.error());
}

val Session::distances(const val& points) {
    if (!packing_) return to_val(kNoFoams);
    const std::vector<float> places = floats_from(points);
    std::vector<float> distances(places.size() / 3, std::numeric_limits<float>::infinity());
    for (const Item& item : packing_->items) {
        const auto surface = store_.surface_of(item.object);
        if (!surface) return to_val(surface.error());
        for (std::size_t i = 0; i < distances.size(); ++i) {
            const Vec3d place{places[3 * i], places[3 * i + 1], places[3 * i + 2]};
            distances[i] = std::min(distances[i], static_cast<float>((*surface)->at(place, item.placement)));
        }
    }
    return typed_array(distances.data(), distances.size());
}

val Session::fit_case(const std::string& design_text, const val& objects, const val& progress) {
    auto project = lay_out_one(design_text, objects);
    if (!project) return to_val(project.error());
    Object& object = store_.objects().front();
    prepare_for_many(object);
    SearchTask task;
    task.fit_case = true;
    task.pack_it = [&object](const Design& tried) { return snug::pack(object, tried); };
    const Progress told = progress_from(progress);
    const auto news = [&](double share, std::optional<long long>) { return go_on(told, share); };
    const auto report = search_design(object, project->design, task, news);
    if (!report) return to_val(report.error());
    val result = val::object();
    result.set("design", design_json(project->design));
    return result;
}

val Session::arrange(const std::string& design_text, const val& objects, const val& progress,
                     const val& better) {
    const auto project = lay_out(design_text, objects);
    if (!project) return to_val(project.error());
    return wasm::arrange(store_.objects(), project->design, {progress, better});
}

val Session::fill(const std::string& design_text, const val& objects, int item, const val& progress,
                  const val& better) {
    const auto project = lay_out(design_text, objects);
    if (!project) return to_val(project.error());
    return wasm::fill(store_.objects(), project->design, static_cast<std::size_t>(item), {progress, better});
}

val Session::rank_cases(const std::string& design_text, const val& objects) {
    const auto project = lay_out(design_text, objects);
    if (!project) return to_val(project.error());
    const Design& design = project->design;
    const auto items = place_items(store_.objects(), design);
    if (!items) return to_val(items.error());
    const Cargo cargo{bounds_of(*items).size(), mass_kg(design), design.search.billed_divisor};
    auto ranking = snug::rank_cases(built_in_cases(), design, cargo);
    return to_val(items->size() > 1 ? as_they_lie(std::move(ranking)) : ranking, design);
}

val Session::workshop_figures(const std::string& design_text, const val& objects) {
    const auto project = lay_out(design_text, objects);
    if (!project) return to_val(project.error());
    const auto packing = snug::pack(store_.objects(), project->design);
    if (!packing) return to_val(packing.error());
    if (!packing->foams) return to_val(kNoFoams);
    const auto pack = workshop_pack(store_.objects(), *packing, *project);
    return pack ? figures_val(*pack) : to_val(pack.error());
}

val Session::output_files(const std::string& design_text, const val& objects, const std::string& language,
                          const val& progress) {
    const auto project = lay_out(design_text, objects);
    if (!project) return to_val(project.error());
    return make_files(store_.objects(), *project, language_of(language), progress_from(progress));
}

}  // namespace snug::wasm
