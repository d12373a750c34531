#include "cli/scene_file.h"

#include "snug/formats/read_object.h"

#include "cli/scene_tools.h"

namespace snug::cli {

Result<Mesh> read_object(Bytes file, const std::filesystem::path& path) {
    return snug::read_object(file, path.string(), scene_tools(path));
}

std::optional<Error> unwanted_units(const Mesh& mesh, bool typed) {
    if (!typed || !mesh.read.in_mm) return {};
    return Error{ErrorKind::usage, say("usage.unit_stated")};
}

}  // namespace snug::cli
