#include <memory>
#include <string>
#include <vector>

#include "snug/formats/shape_text.h"
#include "snug/formats/text_scan.h"

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/files.h"
#include "cli/mesh_file.h"

namespace snug::cli {
namespace {

struct ShapeArguments {
    Language language;
    std::vector<std::string> words;
    std::string file;
};

constexpr std::string_view kEnding = ".shape";

bool is_shape(std::string_view file) {
    return file.size() >= kEnding.size() && same_word(file.substr(file.size() - kEnding.size()), kEnding);
}

int write_shape(const ShapeArguments& arguments) {
    const Language language = arguments.language;
    std::string typed;
    for (const std::string& word : arguments.words) typed += (typed.empty() ? "" : " ") + word;
    const auto solids = parse_shape(typed);
    if (!solids) return report({ErrorKind::usage, solids.error().message}, language);
    if (is_shape(arguments.file)) {
        const std::string line = shape_text(*solids) + "\n";
        if (auto done = write_file(arguments.file, std::as_bytes(std::span(line))); !done)
            return report(done.error(), language);
        const auto done = print(arguments.file + ": " + line);
        return done ? kDone : report(done.error(), language);
    }
    Mesh mesh;
    for (const SimpleSolid& solid : *solids) add_solid(mesh, solid);
    return write_mesh_file(mesh, arguments.file, "Snug shape, mm", language);
}

}  // namespace

CommandSpec shape_command(Language language) {
    const auto a = std::make_shared<ShapeArguments>();
    a->language = language;
    const auto help = [&](const char* code) { return text(say(code), language); };
    return {"shape",
            help("help.shape"),
            "snug shape \"box 143x87x40 r5 + cylinder 63x60 at 0,0,50\" -o camera.stl",
            {{"TEXT", "", help("help.shape.text"), &a->words, true},
             {"-o,--output", "FILE", help("help.shape.file"), &a->file, true}},
            [a] { return write_shape(*a); }};
}

}  // namespace snug::cli
