#include "wasm/session.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "snug/base/stopwatch.h"
#include "snug/design/options_schema.h"
#include "snug/formats/read_object.h"
#include "snug/make.h"
#include "snug/mesh/measure.h"
#include "snug/search/rank_cases.h"
#include "snug/search/search_design.h"

#include "wasm/scene_tools.h"
#include "wasm/workshop_values.h"

namespace snug::wasm {
namespace {

/// The same placements for the same object, whenever it is searched.
constexpr std::uint64_t kSearchSeed = 1;
/// Between two looks at what the page says.
constexpr double kStepMs = 60;
constexpr std::size_t kMostDistinct = 6;

const Error kNoObject{ErrorKind::usage, say("session.no_object")};
const Error kNotOfClouds{ErrorKind::usage, say("session.cloud")};
const Error kNoFoams{ErrorKind::usage, say("session.no_foams")};

bool asks_for_unit(const Mesh& mesh, const Box3d& box, const Design& design) {
    return !mesh.read.in_mm && box.longest_side() > 0 && !design.object.units && !design.object.longest_mm;
}

Object unscaled(const Mesh& mesh) {
    Object object;
    object.mesh.read = mesh.read;
    if (mesh.is_cloud()) object.surface = PointBalls{};
    object.read = {mesh.vertices.size(), mesh.triangles.size()};
    object.measure = measure(mesh);
    return object;
}

}  // namespace

val make_files(Object& object, Project project, Language language, const Progress& progress) {
    Tools tools;
    tools.language = language;
    tools.progress = [&progress](Stage stage) { return stage == Stage::gaps ? progress : Progress(); };
    auto made = make(object, project, tools);
    if (!made) return to_val(made.error());
    if (!made->packing.foams)
        return to_val(Error{ErrorKind::does_not_fit, made->packing.findings.front().message});
    val result = val::object();
    val files = val::array();
    const auto take = [&files](const PackFile& file) -> Result<void> {
        files.call<void>("push", to_val(file));
        return {};
    };
    if (auto done = make_output_files({&object, 1}, project, *made, take); !done) return to_val(done.error());
    result.set("files", files);
    result.set("report", report_json({&object, 1}, project, *made));
    if (made->pack) result.set("pack", to_val(*made->pack));
    return result;
}

val Session::load(const val& bytes, const std::string& name, const std::string& design_text,
                  const val& tools) {
    const auto design = parse_design(design_text);
    if (!design) return to_val(design.error());
    auto mesh = read_object(bytes_from(bytes), name, scene_tools_from(tools));
    if (!mesh) return to_val(mesh.error());
    const Box3d box = bounds(*mesh);
    auto object = prepare(*mesh, *design);
    if (!object && !asks_for_unit(*mesh, box, *design)) return to_val(object.error());

    search_.reset();
    map_.reset();
    packing_.reset();
    surface_.reset();
    object_.reset();
    read_ = std::move(*mesh);
    box_ = box;
    options_ = design->object;
    if (!object) return to_val(unscaled(*read_), box.size(), object.error());
    object_ = std::move(*object);
    return to_val(*object_, box.size(), {});
}

std::optional<Error> Session::prepare_for(const Design& design) {
    if (!read_) return kNoObject;
    if (object_ && options_ == design.object)
        return object_->mesh.read.in_mm ? std::nullopt : implausible_size(box_.size(), design);
    auto object = prepare(*read_, design);
    if (!object) return object.error();
    search_.reset();
    map_.reset();
    packing_.reset();
    surface_.reset();
    options_ = design.object;
    object_ = std::move(*object);
    return {};
}

val Session::describe(const std::string& design_text) {
    const auto design = parse_design(design_text);
    if (!design) return to_val(design.error());
    const auto error = prepare_for(*design);
    if (!error) return to_val(*object_, box_.size(), {});
    if (!read_ || !asks_for_unit(*read_, box_, *design)) return to_val(*error);
    return to_val(unscaled(*read_), box_.size(), error);
}

val Session::mesh() const {
    if (object_) return to_val(object_->mesh);
    return to_val(read_.value_or(Mesh{}));
}

val Session::pack(const std::string& design_text) {
    Stopwatch watch;
    const auto design = parse_design(design_text);
    if (!design) return to_val(design.error());
    if (const auto error = prepare_for(*design)) return to_val(*error);
    if (packing_) prepare_for_many(*object_);  // the first should be seen at once
    auto packing = snug::pack(*object_, *design);
    if (!packing) return to_val(packing.error());
    packing_ = std::move(*packing);
    packed_ = *design;
    val result = to_val(*packing_, watch.lap());
    result.set("dependent", dependent_options(*design));
    return result;
}

val Session::gaps(const val& progress) const {
    if (!packing_ || !packing_->foams) return to_val(kNoFoams);
    if (!object_->whole()) return to_val(kNotOfClouds);
    Packing packing = *packing_;
    const auto measured = measure_fit({&*object_, 1}, packing, packed_, progress_from(progress));
    if (!measured) return to_val(measured.error());
    val result = to_val(*measured->gap);
    result.set("bearing", to_val(*measured->bearing, packed_));
    result.set("findings", to_val(packing.findings));
    return result;
}

val Session::distances(const val& points) {
    if (!packing_) return to_val(kNoFoams);
    if (!surface_) {
        auto surface = SurfaceDistance::build(object_->mesh);
        if (!surface) return to_val(surface.error());
        surface_.emplace(std::move(*surface));
    }
    const std::vector<float> places = floats_from(points);
    std::vector<float> distances(places.size() / 3);
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const Vec3d place{places[3 * i], places[3 * i + 1], places[3 * i + 2]};
        distances[i] = static_cast<float>(surface_->at(place, packing_->items.front().placement));
    }
    return typed_array(distances.data(), distances.size());
}

val Session::start_search(const std::string& design_text) {
    const auto design = parse_design(design_text);
    if (!design) return to_val(design.error());
    if (const auto error = prepare_for(*design)) return to_val(*error);
    prepare_for_many(*object_);
    const auto packing = snug::pack(*object_, *design);
    if (!packing) return to_val(packing.error());
    auto search = PlacementSearch::start(object_->mesh, *object_->prepared, *design, packing->space,
                                         kSearchSeed, packing->available);
    if (!search) return to_val(search.error());
    search_ = std::move(*search);
    searched_ = packing->space;
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

val Session::fit_case(const std::string& design_text, const val& progress) {
    auto design = parse_design(design_text);
    if (!design) return to_val(design.error());
    if (const auto error = prepare_for(*design)) return to_val(*error);
    prepare_for_many(*object_);
    SearchTask task;
    task.fit_case = true;
    const Progress told = progress_from(progress);
    const auto news = [&](double share, std::optional<long long>) { return go_on(told, share); };
    const auto report = search_design(object_->mesh, *object_->prepared, *design, task, news);
    if (!report) return to_val(report.error());
    val result = val::object();
    result.set("design", design_json(*design));
    return result;
}

val Session::start_map(const std::string& design_text) {
    const auto design = parse_design(design_text);
    if (!design) return to_val(design.error());
    if (const auto error = prepare_for(*design)) return to_val(*error);
    prepare_for_many(*object_);
    const auto packing = snug::pack(*object_, *design);
    if (!packing) return to_val(packing.error());
    map_.emplace(object_->mesh, *object_->prepared, *design, packing->space, kMapDirections,
                 packing->available);
    return to_val(*map_);
}

val Session::map_step() {
    if (!map_) return to_val(Error{ErrorKind::cancelled, say("session.changed")});
    Stopwatch watch;
    for (double spent = 0; spent < kStepMs && map_->passes() < kMapPasses; spent += watch.lap()) map_->step();
    return to_val(*map_);
}

val Session::rank_cases(const std::string& design_text) {
    const auto design = parse_design(design_text);
    if (!design) return to_val(design.error());
    if (const auto error = prepare_for(*design)) return to_val(*error);
    const Placement placement = place(object_->mesh, design->placement.rotation_deg, {});
    const Cargo cargo{placement.bounds.size(), design->workshop.mass_kg, design->search.billed_divisor};
    return to_val(snug::rank_cases(built_in_cases(), *design, cargo), *design);
}

val Session::workshop_figures(const std::string& project_text) {
    const auto project = parse_project(project_text);
    if (!project) return to_val(project.error());
    if (const auto error = prepare_for(project->design)) return to_val(*error);
    const auto packing = snug::pack(*object_, project->design);
    if (!packing) return to_val(packing.error());
    if (!packing->foams) return to_val(kNoFoams);
    const auto pack = workshop_pack({&*object_, 1}, *packing, *project);
    return pack ? figures_val(*pack) : to_val(pack.error());
}

val Session::output_files(const std::string& project_text, const std::string& language, const val& progress) {
    const auto project = parse_project(project_text);
    if (!project) return to_val(project.error());
    if (const auto error = prepare_for(project->design)) return to_val(*error);
    return make_files(*object_, *project, language_of(language), progress_from(progress));
}

}  // namespace snug::wasm
