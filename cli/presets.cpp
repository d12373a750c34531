#include "snug/design/presets.h"

#include <array>
#include <string>

#include "snug/base/text.h"

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/user_presets.h"
#include "cli/wrapped.h"

namespace snug::cli {
namespace {

std::string line(const std::array<std::string, 5>& cells) {
    return padded(cells[0], 13) + padded(cells[1], 24) + padded(cells[2], 11) + padded(cells[3], 7) +
           cells[4] + "\n";
}

std::string line_of(const Preset& preset, Language language) {
    const std::string title(title_of(preset, language));
    return line({preset.name, dimensions(preset.block_mm) + " mm", number(preset.clearance_mm) + " mm",
                 preset.density_kg_m3 ? number(*preset.density_kg_m3) : std::string("-"),
                 preset.rigid ? text(say("list.rigid", {{"title", title}}), language) : title});
}

int list_presets(Language language) {
    const auto presets = known_presets();
    if (!presets) return report(presets.error(), language);
    const auto said = [&](const Message& message) { return snug::text(message, language); };
    std::string text = line({said(say("list.name")), said(say("list.block")), said(say("list.clearance")),
                             said(say("list.density")), said(say("list.what"))});
    for (const Preset& preset : *presets) text += line_of(preset, language);
    text += "\n" + said(say("list.own_presets", {{"file", user_presets_path().string()}})) +
            "\n"
            "  [{\"name\": \"ours\", \"title\": \"black slit sponge\", \"block_mm\": [20, 12, 12], "
            "\"clearance_mm\": 1,\n"
            "    \"density_kg_m3\": 28, \"rigid\": false, \"worked\": \"pull the blocks out\"}]\n";
    const auto done = print(text);
    return done ? kDone : report(done.error(), language);
}

}  // namespace

CommandSpec presets_command(Language language) {
    return {"presets", text(say("help.presets"), language), "snug presets", {}, [language] {
                return list_presets(language);
            }};
}

}  // namespace snug::cli
