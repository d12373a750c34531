#include "cli/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "snug/base/text.h"
#include "snug/formats/mesh_files.h"

#include "cli/console.h"
#include "cli/files.h"

namespace snug::cli {
namespace {

Result<FileBytes> encoded(const Mesh& mesh, const std::filesystem::path& path, std::string_view title) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    if (ending == ".stl") return write_stl(mesh.vertices, mesh.triangles, title);
    if (ending == ".ply") return write_ply(mesh.vertices, mesh.triangles, {});
    if (ending == ".obj") return write_obj(mesh.vertices, mesh.triangles);
    if (ending == ".off") return write_off(mesh.vertices, mesh.triangles);
    return fail(ErrorKind::usage, say("usage.sample_name", {{"file", path.string()}}));
}

}  // namespace

int write_mesh_file(const Mesh& mesh, const std::string& file, std::string_view title, Language language) {
    const auto bytes = encoded(mesh, file, title);
    if (!bytes) return report(bytes.error(), language);
    if (auto done = write_file(file, *bytes); !done) return report(done.error(), language);
    const auto done = print(text(say("sample.written", {{"file", file},
                                                        {"vertices", mesh.vertices.size()},
                                                        {"size", dimensions(bounds(mesh).size())}}),
                                 language) +
                            "\n");
    return done ? kDone : report(done.error(), language);
}

}  // namespace snug::cli
