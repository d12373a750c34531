#include "wasm/projects.h"

#include <cstddef>
#include <utility>

#include "snug/design/options_schema.h"
#include "snug/formats/bundle.h"

#include "wasm/scene_tools.h"
#include "wasm/values.h"

namespace snug::wasm {
namespace {

/// A design that says the object's choices and nothing else.
std::string own_text(const ObjectOptions& own) {
    Design design;
    design.object = own;
    return design_json(design);
}

}  // namespace

Result<Project> project_from(const std::string& design_text, const val& objects) {
    auto design = parse_design(design_text);
    if (!design) return tl::unexpected(design.error());
    Project project;
    project.design = std::move(*design);
    project.objects.clear();
    const auto count = objects["length"].as<std::size_t>();
    for (std::size_t i = 0; i < count; ++i) {
        const val given = objects[i];
        ProjectObject object;
        object.file = {given["name"].as<std::string>(),
                       static_cast<unsigned long long>(given["bytes"].as<double>()),
                       given["sha256"].as<std::string>()};
        if (given["shape"].isString()) object.file.shape = given["shape"].as<std::string>();
        if (!given["own"].isNull()) {
            const auto own = parse_design(given["own"].as<std::string>());
            if (!own) return tl::unexpected(own.error());
            object.own = own->object;
        }
        project.objects.push_back(std::move(object));
    }
    return project;
}

val parse(const std::string& project_text) {
    auto project = parse_project(project_text);
    if (!project) return to_val(project.error());
    take_over_one_item(*project);
    val objects = val::array();
    for (const ProjectObject& object : project->objects) {
        val one = to_val(object.file);
        one.set("own", object.own ? val(own_text(*object.own)) : val::null());
        objects.call<void>("push", one);
    }
    val result = val::object();
    result.set("objects", objects);
    result.set("design", design_json(project->design));
    result.set("dependent", dependent_options(project->design));
    return result;
}

val packed_project(const val& zip, const val& tools) {
    const auto bytes = bytes_from(zip);
    const auto packed = find_packed_project(bytes, scene_tools_from(tools));
    if (!packed) return to_val(packed.error());
    val result = val::object();
    result.set("text", *packed ? val((*packed)->text) : val::null());
    result.set("whole", *packed && (*packed)->has_object);
    return result;
}

}  // namespace snug::wasm
