#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "snug/design/option_text.h"
#include "snug/words/words.h"

#include "cli/completions.h"
#include "cli/console.h"
#include "cli/manual_page.h"

namespace snug::cli {
namespace {

struct Kind {
    std::string_view name;
    std::string (*made)(std::span<const CommandSpec> commands, Language language);
};

constexpr std::array<Kind, 4> kKinds{
    {{"man", manual_page}, {"bash", bash_completions}, {"zsh", zsh_completions}, {"fish", fish_completions}}};

std::vector<std::string_view> kind_names() {
    std::vector<std::string_view> names;
    for (const Kind& kind : kKinds) names.push_back(kind.name);
    return names;
}

int generate(const std::string& name, Language language) {
    const auto kind =
        std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& one) { return one.name == name; });
    if (kind == kKinds.end())
        return report(
            not_what_it_takes("KIND", say("takes.one_of", {{"words", each_as_it_is(kind_names())}}), name)
                .value(),
            language);
    const auto done = print(kind->made(all_commands(language), language));
    return done ? kDone : report(done.error(), language);
}

}  // namespace

CommandSpec generate_command(Language language) {
    const auto name = std::make_shared<std::string>();
    std::string takes;
    for (const std::string_view one : kind_names()) takes += (takes.empty() ? "" : "|") + std::string(one);
    return {
        "generate",
        text(say("help.generate"), language),
        "snug generate man > snug.1",
        {{"KIND", takes, text(say("help.generate.kind", {{"words", each_as_it_is(kind_names())}}), language),
          name.get(), true}},
        [name, language] { return generate(*name, language); }};
}

}  // namespace snug::cli
