#include "snug/design/presets.h"

#include <algorithm>

#include "snug/base/text.h"
#include "snug/design/json_reader.h"
#include "snug/words/catalogue.h"
#include "snug/words/words.h"

namespace snug {
namespace {

Result<Preset> preset_from(const nlohmann::json& json, const std::string& path) {
    JsonReader reader(json, path);
    Preset preset;
    std::string division(name_of(preset.division));
    reader.require("name");
    reader.require("block_mm");
    reader.read("name", preset.name)
        .read("title", preset.title)
        .read("block_mm", preset.block_mm)
        .read("clearance_mm", preset.clearance_mm)
        .read("density_kg_m3", preset.density_kg_m3)
        .read("creep_kpa", preset.creep_kpa)
        .read("rigid", preset.rigid)
        .read("worked", preset.worked)
        .read("division", division)
        .read("wall_mm", preset.wall_mm);
    if (const auto known = value_named<Division>(division))
        preset.division = *known;
    else
        reader.refuse("division", say("preset.division"));
    if (preset.name.empty()) reader.refuse("name", say("json.word"));
    if (preset.density_kg_m3 && *preset.density_kg_m3 <= 0)
        reader.refuse("density_kg_m3", say("json.above_0"));
    if (preset.creep_kpa && *preset.creep_kpa <= 0) reader.refuse("creep_kpa", say("json.above_0"));
    if (preset.wall_mm && *preset.wall_mm <= 0) reader.refuse("wall_mm", say("json.above_0"));
    if (const auto problem = reader.problem()) return fail(ErrorKind::usage, *problem);

    Design design;
    apply(preset, design);
    if (const auto possible = checked(design); !possible)
        return fail(ErrorKind::usage, in_file(path, possible.error().message));
    return preset;
}

}  // namespace

const std::vector<Preset>& built_in_presets() {
    static const std::vector<Preset> presets{
        {"paper",
         text(say("preset/paper")),
         {15, 15, 22},
         0,
         {},
         {},
         false,
         "pull the blocks out of their slits"},
        {"slit-10",
         text(say("preset/slit-10")),
         {20, 10, 10},
         0,
         25,
         {},
         false,
         "pull the blocks out of their slits"},
        {"slit-12.7",
         text(say("preset/slit-12.7")),
         {25.4, 12.7, 12.7},
         0,
         25,
         {},
         false,
         "pull the blocks out of their slits"},
        {"slit-15",
         text(say("preset/slit-15")),
         {15, 15, 15},
         0,
         25,
         {},
         false,
         "pull the blocks out of their slits"},
        {"cube-25", text(say("preset/cube-25")), {25, 25, 25}, 0, 25, {}, false, "glue or stack the cubes"},
        {"sheet-5",
         text(say("preset/sheet-5")),
         {5, 2.5, 2.5},
         1,
         33,
         {},
         false,
         "cut each sheet, then glue the stack",
         Division::across},
        {"sheet-10",
         text(say("preset/sheet-10")),
         {10, 2.5, 2.5},
         1,
         33,
         {},
         false,
         "cut each sheet, then glue the stack",
         Division::across},
        {"lego-brick",
         text(say("preset/lego-brick")),
         {9.6, 8, 8},
         1,
         {},
         {},
         true,
         "build it layer by layer",
         Division::none,
         16},
        {"lego-plate",
         text(say("preset/lego-plate")),
         {3.2, 8, 8},
         1,
         {},
         {},
         true,
         "build it layer by layer",
         Division::none,
         16},
        {"print",
         text(say("preset/print")),
         {2, 2, 2},
         1,
         {},
         {},
         true,
         "print each half cavity up",
         Division::all,
         6},
        {"mill",
         text(say("preset/mill")),
         {5, 2, 2},
         1,
         33,
         {},
         false,
         "mill each half from its cavity's side",
         Division::all},
        {"cast",
         text(say("preset/cast")),
         {5, 5, 5},
         1,
         {},
         {},
         false,
         "print the moulds, pour, let it set and pull it out",
         Division::all},
    };
    return presets;
}

std::string title_of(const Preset& preset, Language language) {
    const std::string code = "preset/" + preset.name;
    const Message title = say(code);
    return wording(code) && text(title) == preset.title ? text(title, language) : preset.title;
}

Result<std::vector<Preset>> parse_presets(std::string_view text) {
    const auto json = parse_json(text, ErrorKind::usage);
    if (!json) return tl::unexpected(json.error());
    if (!json->is_array())
        return fail(ErrorKind::usage, say("preset.no_list", {{"example", "[{...}, {...}]"}}));
    std::vector<Preset> presets;
    for (std::size_t i = 0; i < json->size(); ++i) {
        auto preset = preset_from((*json)[i], "preset " + std::to_string(i + 1));
        if (!preset) return tl::unexpected(preset.error());
        presets.push_back(std::move(*preset));
    }
    return presets;
}

Result<Preset> find_preset(const std::vector<Preset>& known, std::string_view name) {
    const auto found =
        std::find_if(known.rbegin(), known.rend(), [&](const Preset& p) { return p.name == name; });
    if (found != known.rend()) return *found;
    std::vector<Message> names;
    for (const Preset& preset : known) names.push_back(as_it_is(preset.name));
    return fail(ErrorKind::usage, say("preset.unknown", {{"name", quoted(name)}, {"known", names}}));
}

void apply(const Preset& preset, Design& design) {
    design.space.preset = preset.name;
    design.space.block_mm = preset.block_mm;
    design.cut.clearance_mm = preset.clearance_mm;
    design.case_options.division = preset.division;
    // A foam of known data stays what it is in other blocks.
    const auto& foam = design.protection.foam;
    design.fit.creep_kpa = foam ? foam->creep_kpa : preset.creep_kpa;
}

bool is_rigid(const Design& design) {
    if (design.workshop.work == Workshop::bricks) return true;
    const auto preset = find_preset(built_in_presets(), design.space.preset);
    return preset && preset->rigid;
}

}  // namespace snug
