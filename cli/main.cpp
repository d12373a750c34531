#include "cli/arguments.h"
#include "cli/interrupt.h"

int main(int argc, char** argv) {
    using namespace snug::cli;
    catch_interrupts();
    const CommandSpec program{
        "snug",
        "Snug designs protective foam for an object that must travel: from a 3D model or a scan it\n"
        "makes two foam halves in the blocks that real foam has.",
        "Example: snug make vase.stl -o vase-foam\nEvery command has --help with an example.",
        {},
        {}};
    return run_program(argc, argv, program,
                       {make_command(), inspect_command(), sample_command(), presets_command(),
                        cases_command(), studio_command()});
}
