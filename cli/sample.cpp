#include <memory>
#include <string>

#include "snug/samples/samples.h"

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/mesh_file.h"

namespace snug::cli {
namespace {

struct SampleArguments {
    Language language;
    std::string name;
    std::string file;
};

int write_sample(const SampleArguments& arguments) {
    const Language language = arguments.language;
    const auto mesh = sample(arguments.name);
    if (!mesh) return report(mesh.error(), language);
    return write_mesh_file(*mesh, arguments.file, "Snug sample, mm", language);
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
