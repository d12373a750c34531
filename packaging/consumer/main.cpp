// Makes foams of a sample and writes them into a folder.
// Usage: consumer FOLDER

#include <filesystem>
#include <fstream>
#include <iostream>
#include <snug/make.h>
#include <snug/samples/samples.h>

int main(int argc, char** argv) {
    if (argc != 2) return 1;
    const auto say = [](const snug::Error& error) {
        std::cerr << snug::text(error.message, snug::Language::english) << '\n';
        return 1;
    };
    auto mesh = snug::sample("vase");
    if (!mesh) return say(mesh.error());
    auto design = snug::parse_design(
        R"({"space": {"block_mm": [20, 10, 10], "blocks": "auto", "wall_mm": 40}, "cut": {"clearance_mm": 1}})");
    if (!design) return say(design.error());
    snug::Project project;
    project.design = *design;
    auto object = snug::prepare(std::move(*mesh), project.design);
    if (!object) return say(object.error());
    auto made = snug::make(*object, project);
    if (!made) return say(made.error());
    const auto write = [&](const snug::PackFile& file) -> snug::Result<void> {
        std::ofstream(std::filesystem::path(argv[1]) / file.name, std::ios::binary)
            .write(reinterpret_cast<const char*>(file.bytes.data()),
                   static_cast<std::streamsize>(file.bytes.size()));
        return {};
    };
    if (auto done = snug::make_output_files({&*object, 1}, project, *made, write); !done)
        return say(done.error());
}
