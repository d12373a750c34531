#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/interrupt.h"

int main(int argc, char** argv) {
    using namespace snug::cli;
    const auto language = typed_language(argc, argv);
    if (!language) return report(language.error(), snug::Language::english);
    catch_interrupts(*language);
    return run_program(argc, argv, *language, all_commands(*language));
}
