#include <set>
#include <string>
#include <utility>
#include <vector>

#include <emscripten/bind.h>

#include "snug/design/brick_parts.h"
#include "snug/design/command_line.h"
#include "snug/design/options_schema.h"
#include "snug/formats/mesh_files.h"
#include "snug/formats/read_object.h"
#include "snug/object/prepare.h"
#include "snug/samples/samples.h"

#include "wasm/projects.h"
#include "wasm/protection_values.h"
#include "wasm/scene_tools.h"
#include "wasm/session.h"
#include "wasm/shape_values.h"
#include "wasm/values.h"

// What the browser calls. No logic: values in, values out, errors as {error, kind}.

namespace snug::wasm {
namespace {

std::string version() {
    return SNUG_VERSION;
}

std::string default_design() {
    return design_json({});
}

val presets() {
    val list = val::array();
    for (const Preset& preset : built_in_presets()) list.call<void>("push", to_val(preset));
    return list;
}

/// {sizes: ["1x1"], colors: [{name, css}]}: what bricks there are.
val bricks() {
    std::set<std::pair<int, int>> sizes;
    for (const BrickPart& part : brick_parts()) sizes.insert({part.width, part.length});
    val size_list = val::array(), colors = val::array();
    for (const auto& [width, length] : sizes)
        size_list.call<void>("push", std::to_string(width) + "x" + std::to_string(length));
    for (const BrickColor& color : brick_colors()) {
        val one = val::object();
        one.set("name", std::string(color.name));
        one.set("css", "rgb(" + std::to_string(color.red) + " " + std::to_string(color.green) + " " +
                           std::to_string(color.blue) + ")");
        colors.call<void>("push", one);
    }
    val result = val::object();
    result.set("sizes", size_list);
    result.set("colors", colors);
    return result;
}

/// {text}: `objects` as in projects.h.
val project_text(const std::string& design, const val& objects) {
    const auto project = project_from(design, objects);
    if (!project) return to_val(project.error());
    val result = val::object();
    result.set("text", project_json(*project));
    return result;
}

/// {text}: the `snug make` that gives the design from the objects' files, in a language ("en", "ja").
val command_line_text(const std::string& design, const val& objects, const std::string& language) {
    const auto project = project_from(design, objects);
    if (!project) return to_val(project.error());
    std::vector<std::string> files;
    for (const ProjectObject& object : project->objects) files.push_back(object.file.name);
    val result = val::object();
    result.set("text", command_line(*project, files, built_in_names(), language_of(language)));
    return result;
}

val samples() {
    val list = val::array();
    for (const std::string_view name : sample_names()) list.call<void>("push", std::string(name));
    return list;
}

/// {name, bytes}: one of the objects that Snug generates itself, as a file.
val sample_file(const std::string& name) {
    const auto mesh = sample(name);
    if (!mesh) return to_val(mesh.error());
    return to_val(PackFile{name + ".ply", write_ply(mesh->vertices, mesh->triangles, {})});
}

/// {files, report, pack}, or what is wrong; in a language ("en", "ja").
val make(const val& object_bytes, const std::string& project_text, const val& tools,
         const std::string& language) {
    const auto project = parse_project(project_text);
    if (!project) return to_val(project.error());
    const std::string& name = project->objects.front().file.name;
    auto mesh = read_object(bytes_from(object_bytes), name, scene_tools_from(tools));
    if (!mesh) return to_val(mesh.error());
    auto object = prepare(std::move(*mesh), design_for(*project, 0));
    if (!object) return to_val(object.error());
    object->name = name;
    return make_files({&*object, 1}, *project, language_of(language), {});
}

}  // namespace
}  // namespace snug::wasm

EMSCRIPTEN_BINDINGS(snug) {
    namespace bound = snug::wasm;
    using emscripten::function;
    function("version", &bound::version);
    function("defaultDesign", &bound::default_design);
    function("presets", &bound::presets);
    function("bricks", &bound::bricks);
    function("parseProject", &bound::parse);
    function("packedProject", &bound::packed_project);
    function("projectText", &bound::project_text);
    function("commandLine", &bound::command_line_text);
    function("optionsSchema", &snug::options_schema);
    function("protectionChoices", &bound::protection_choices);
    function("parseFoams", &bound::foams_val);
    function("parseShape", &bound::shape_val);
    function("samples", &bound::samples);
    function("sampleFile", &bound::sample_file);
    function("make", &bound::make);
    emscripten::class_<bound::Session>("Session")
        .constructor<>()
        .function("load", &bound::Session::load)
        .function("keep", &bound::Session::keep)
        .function("describe", &bound::Session::describe)
        .function("mesh", &bound::Session::mesh)
        .function("pack", &bound::Session::pack)
        .function("gaps", &bound::Session::gaps)
        .function("drops", &bound::Session::drops)
        .function("contacts", &bound::Session::contacts)
        .function("protectingWalls", &bound::Session::protecting_walls)
        .function("plan", &bound::Session::plan)
        .function("zones", &bound::Session::zones)
        .function("distances", &bound::Session::distances)
        .function("startSearch", &bound::Session::start_search)
        .function("searchStep", &bound::Session::search_step)
        .function("distinct", &bound::Session::distinct)
        .function("fitCase", &bound::Session::fit_case)
        .function("arrange", &bound::Session::arrange)
        .function("fill", &bound::Session::fill)
        .function("startMap", &bound::Session::start_map)
        .function("mapStep", &bound::Session::map_step)
        .function("rankCases", &bound::Session::rank_cases)
        .function("workshopFigures", &bound::Session::workshop_figures)
        .function("outputFiles", &bound::Session::output_files);
}
