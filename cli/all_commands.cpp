#include "cli/arguments.h"
#include "cli/commands.h"

namespace snug::cli {

std::vector<CommandSpec> all_commands(Language language) {
    return {make_command(language),    plan_command(language),  inspect_command(language),
            sample_command(language),  shape_command(language), presets_command(language),
            cases_command(language),   foams_command(language), studio_command(language),
            generate_command(language)};
}

}  // namespace snug::cli
