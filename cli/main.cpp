#include <csignal>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "cli/commands.h"
#include "cli/interrupt.h"

int main(int argc, char** argv) {
    using namespace snug::cli;
    catch_interrupts();

    CLI::App program(
        "Snug designs protective foam for an object that must travel: from a 3D model or a scan it\n"
        "makes two foam halves in the blocks that real foam has.",
        "snug");
    program.set_version_flag("--version", "snug " SNUG_VERSION);
    program.set_help_flag("-h,--help", "Print this help");
    program.require_subcommand(1);
    program.footer("Example: snug make vase.stl -o vase-foam\nEvery command has --help with an example.");

    Command chosen;
    add_make(program, chosen);
    add_inspect(program, chosen);
    add_sample(program, chosen);
    add_presets(program, chosen);
    add_cases(program, chosen);
    add_studio(program, chosen);

    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? kDone : kWrongUsage;
    }
    return chosen();
}
