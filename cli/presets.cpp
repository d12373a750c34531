#include "snug/design/presets.h"

#include <string>

#include <fmt/core.h>

#include "snug/base/text.h"

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/user_presets.h"

namespace snug::cli {
namespace {

std::string line(const Preset& preset) {
    return fmt::format("{:<13}{:<24}{:<11}{:<7}{}\n", preset.name, dimensions(preset.block_mm) + " mm",
                       number(preset.clearance_mm) + " mm",
                       preset.density_kg_m3 ? number(*preset.density_kg_m3) : std::string("-"),
                       preset.title + (preset.rigid ? " (rigid: holds, does not cushion)" : ""));
}

int list_presets() {
    const auto presets = known_presets();
    if (!presets) return report(presets.error());
    std::string text = fmt::format("{:<13}{:<24}{:<11}{:<7}{}\n", "name", "block x, y, z", "clearance",
                                   "kg/m3", "what it is");
    for (const Preset& preset : *presets) text += line(preset);
    text += fmt::format(
        "\nAdd your own in {}, for example:\n"
        "  [{{\"name\": \"ours\", \"title\": \"black slit sponge\", \"block_mm\": [20, 12, 12], "
        "\"clearance_mm\": 1,\n"
        "    \"density_kg_m3\": 28, \"rigid\": false, \"worked\": \"pull the blocks out\"}}]\n",
        user_presets_path().string());
    const auto done = print(text);
    return done ? kDone : report(done.error());
}

}  // namespace

CommandSpec presets_command() {
    return {"presets",
            "List the foams that Snug knows, and where to add your own",
            "Example: snug presets",
            {},
            list_presets};
}

}  // namespace snug::cli
