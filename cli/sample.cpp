#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/core.h>

#include "snug/base/text.h"
#include "snug/formats/mesh_files.h"
#include "snug/samples/samples.h"

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/files.h"

namespace snug::cli {
namespace {

struct SampleArguments {
    std::string name;
    std::string file;
};

Result<FileBytes> encoded(const Mesh& mesh, const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    if (ending == ".stl") return write_stl(mesh.vertices, mesh.triangles, "Snug sample, mm");
    if (ending == ".ply") return write_ply(mesh.vertices, mesh.triangles, {});
    if (ending == ".obj") return write_obj(mesh.vertices, mesh.triangles);
    if (ending == ".off") return write_off(mesh.vertices, mesh.triangles);
    return fail(ErrorKind::usage, say("usage.sample_name", {{"file", path.string()}}));
}

int write_sample(const SampleArguments& arguments) {
    const auto mesh = sample(arguments.name);
    if (!mesh) return report(mesh.error());
    const auto bytes = encoded(*mesh, arguments.file);
    if (!bytes) return report(bytes.error());
    if (auto done = write_file(arguments.file, *bytes); !done) return report(done.error());
    const auto done = print(fmt::format("{}: {}, {} mm\n", arguments.file,
                                        counted(mesh->vertices.size(), "vertex", "vertices"),
                                        dimensions(bounds(*mesh).size())));
    return done ? kDone : report(done.error());
}

}  // namespace

CommandSpec sample_command() {
    const auto a = std::make_shared<SampleArguments>();
    return {"sample",
            "Write an object that Snug generates, to try things with",
            "Example: snug sample vase -o vase.stl",
            {{"NAME", "", "torus, vase, figurine or camera", &a->name, true},
             {"-o,--output", "FILE", "The file; its ending says the format: .stl .ply .obj .off", &a->file,
              true}},
            [a] { return write_sample(*a); }};
}

}  // namespace snug::cli
