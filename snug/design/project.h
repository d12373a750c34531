#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/design.h"

namespace snug {

/// The object's file as it was when the project was written.
struct ObjectFile {
    std::string name;  ///< without folders; looked for beside the project
    unsigned long long bytes = 0;
    std::string sha256;  ///< 64 hexadecimal digits
    /// What is made of measurements is all in the project: the file's text (formats/shape.h), else empty.
    std::string shape = {};
    friend bool operator==(const ObjectFile&, const ObjectFile&) = default;
};

/// An object of a project.
struct ProjectObject {
    ObjectFile file;
    std::optional<ObjectOptions> own;  ///< none: as the design has it for all
    friend bool operator==(const ProjectObject&, const ProjectObject&) = default;
};

/// A project file (*.snug.json): which objects, and every choice.
struct Project {
    std::vector<ProjectObject> objects{1};  ///< one at least; the design's items are of them
    Design design;
    friend bool operator==(const Project&, const Project&) = default;
};

/// The design as it is for one of the objects.
[[nodiscard]] Design design_for(const Project& project, std::size_t object);
/// Where one item alone lies in the case, its own choices and its object's become the design's, which
/// searches and fields change; several stay as they are.
void take_over_one_item(Project& project);
/// An item's own name, or that of its file.
[[nodiscard]] std::string item_name(const Project& project, const ItemOptions& item);
/// What lies in the case, as people call it: the name of a single item; "body, lens x2" for several.
[[nodiscard]] std::string names_of_items(const Project& project);

/// {snug: 2, objects: [{name, bytes, sha256, shape, options}], design: {every option}}; `options` where an
/// object has its own, `shape` where it is made of measurements. Reading it back and writing it again gives
/// the same bytes.
[[nodiscard]] std::string project_json(const Project& project);

/// Also of version 1, which had one `object`. Fails (kind input) with the path of the field that is wrong,
/// unknown or out of range ("design.fit.least_rib_mm"); a project of a newer version is refused.
[[nodiscard]] Result<Project> parse_project(std::string_view json);

/// The design alone, as it stands in a project. Ranges are told without a path: whoever holds a design alone
/// sees its fields.
[[nodiscard]] std::string design_json(const Design& design);
[[nodiscard]] Result<Design> parse_design(std::string_view json);

}  // namespace snug
