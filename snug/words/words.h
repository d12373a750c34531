#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "snug/base/message.h"

namespace snug {

enum class Language {
    english,
    japanese,
};
/// "en", "ja"
[[nodiscard]] std::string_view language_name(Language language);
[[nodiscard]] std::optional<Language> language_from_name(std::string_view name);

/// "figurine.stl: there are no triangles in this file"
[[nodiscard]] inline Message in_file(std::string_view name, Message problem) {
    return say("in_file", {{"file", name}, {"problem", std::move(problem)}});
}

/// The sentence of a message in a language, as the catalogue has it (snug/words/catalogue.h).
[[nodiscard]] std::string text(const Message& message, Language language = Language::english);

}  // namespace snug
