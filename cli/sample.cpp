#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <string>

#include "snug/base/text.h"
#include "snug/formats/mesh_files.h"
#include "snug/samples/samples.h"

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/files.h"

namespace snug::cli {
namespace {

struct SampleArguments {
    Language language;
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
    const Language language = arguments.language;
    const auto mesh = sample(arguments.name);
    if (!mesh) return report(mesh.error(), language);
    const auto bytes = encoded(*mesh, arguments.file);
    if (!bytes) return report(bytes.error(), language);
    if (auto done = write_file(arguments.file, *bytes); !done) return report(done.error(), language);
    const auto done = print(text(say("sample.written", {{"file", arguments.file},
                                                        {"vertices", mesh->vertices.size()},
                                                        {"size", dimensions(bounds(*mesh).size())}}),
                                 language) +
                            "\n");
    return done ? kDone : report(done.error(), language);
}

}  // namespace

CommandSpec sample_command(Language language) {
    const auto a = std::make_shared<SampleArguments>();
    a->language = language;
    const auto help = [&](const Message& message) { return text(message, language); };
    const Message names = say("help.sample.name", {{"names", each_as_it_is(sample_names())}});
    return {"sample",
            help(say("help.sample")),
            "snug sample vase -o vase.stl",
            {{"NAME", "", help(names), &a->name, true},
             {"-o,--output", "FILE", help(say("help.sample.file")), &a->file, true}},
            [a] { return write_sample(*a); }};
}

}  // namespace snug::cli
