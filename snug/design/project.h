#pragma once

#include <string>
#include <string_view>

#include "snug/base/result.h"
#include "snug/design/design.h"

namespace snug {

/// The object's file as it was when the project was written.
struct ObjectFile {
    std::string name;  ///< without folders; looked for beside the project
    unsigned long long bytes = 0;
    std::string sha256;  ///< 64 hexadecimal digits
    friend bool operator==(const ObjectFile&, const ObjectFile&) = default;
};

/// A project file (*.snug.json): which object, and every choice.
struct Project {
    ObjectFile object;
    Design design;
    friend bool operator==(const Project&, const Project&) = default;
};

/// {snug: 1, object: {name, bytes, sha256}, design: {every option}}. Reading it back and writing it again
/// gives the same bytes.
[[nodiscard]] std::string project_json(const Project& project);

/// Fails (kind input) with the path of the field that is wrong, unknown or out of range
/// ("design.fit.least_rib_mm"); a project of a newer version is refused.
[[nodiscard]] Result<Project> parse_project(std::string_view json);

/// The design alone, as it stands in a project. Ranges are told without a path: whoever holds a design alone
/// sees its fields.
[[nodiscard]] std::string design_json(const Design& design);
[[nodiscard]] Result<Design> parse_design(std::string_view json);

}  // namespace snug
