#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace snug {

/// The words of an enum's values, in their order, as files and command lines have them. Specialised beside
/// each enum that has some: `static constexpr std::string_view list[]`. An empty first word stands for none.
template <class Enum>
struct Names;

template <class Enum>
[[nodiscard]] constexpr std::span<const std::string_view> names_of() {
    return Names<Enum>::list;
}

template <class Enum>
[[nodiscard]] constexpr std::string_view name_of(Enum value) {
    return Names<Enum>::list[static_cast<std::size_t>(value)];
}

template <class Enum>
[[nodiscard]] constexpr std::optional<Enum> value_named(std::string_view name) {
    std::size_t at = 0;
    for (const std::string_view each : names_of<Enum>()) {
        if (each == name && !name.empty()) return static_cast<Enum>(at);
        ++at;
    }
    return {};
}

/// "a4, letter or a3"
[[nodiscard]] inline std::string any_of(std::span<const std::string_view> words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += std::string(i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + std::string(words[i]);
    return text;
}

}  // namespace snug
