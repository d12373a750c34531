#include <array>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "snug/base/text.h"
#include "snug/design/option_json.h"
#include "snug/fabricate/kit/shock_text.h"

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/user_foams.h"
#include "cli/wrapped.h"

namespace snug::cli {
namespace {

using Json = nlohmann::ordered_json;

struct FoamsArguments {
    Language language;
    bool json = false;
};

std::string line(const std::array<std::string, 6>& cells) {
    constexpr std::array<std::size_t, 5> kWidths{17, 8, 12, 25, 16};
    std::string text;
    for (std::size_t i = 0; i < kWidths.size(); ++i) text += padded(cells[i], kWidths[i]);
    return text + cells.back() + "\n";
}

std::string or_dash(const std::optional<double>& value) {
    return value ? number(*value) : std::string("-");
}

std::string foams_text(const std::vector<FoamMaterial>& foams, Language language) {
    const auto said = [&](const Message& message) { return snug::text(message, language); };
    std::string text = line({said(say("list.name")), said(say("list.density")), said(say("list.bears")),
                             said(say("list.curve")), said(say("list.data")), said(say("list.what"))});
    for (const FoamMaterial& foam : foams) {
        text += line({foam.name, or_dash(foam.density_kg_m3), or_dash(foam.creep_kpa), said(curve_text(foam)),
                      said(status_text(foam.status)), title_of(foam, language)});
        if (!foam.source.empty()) text += "    " + foam.source + "\n";
    }
    return text + "\n" + said(say("list.own_foams", {{"file", user_foams_path().string()}})) +
           "\n"
           "  [{\"name\": \"ours\", \"title\": \"black sheet\", \"curve\": [[0.1, 20], [0.5, 110]], "
           "\"status\": \"measured\"},\n"
           "   {\"name\": \"tested\", \"points\": [[2.8, 47, 50, 610], [4.1, 41, 50, 610], [5.5, 39, 50, "
           "610], "
           "[6.9, 39, 50, 610], [8.3, 41, 50, 610]]}]\n";
}

/// As foams.json has them.
std::string foams_json(std::vector<FoamMaterial> foams) {
    Json json = Json::array();
    for (FoamMaterial& foam : foams) {
        OptionList list;
        visit_options(list, foam);
        json.push_back(json_of(list));
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

int list_foams(const FoamsArguments& arguments) {
    const auto foams = known_foams();
    if (!foams) return report(foams.error(), arguments.language);
    const auto done = print(arguments.json ? foams_json(*foams) : foams_text(*foams, arguments.language));
    return done ? kDone : report(done.error(), arguments.language);
}

}  // namespace

CommandSpec foams_command(Language language) {
    const auto a = std::make_shared<FoamsArguments>();
    a->language = language;
    return {"foams",
            text(say("help.foams"), language),
            "snug foams",
            {{"--json", "", text(say("help.foams.json"), language), &a->json}},
            [a] { return list_foams(*a); }};
}

}  // namespace snug::cli
