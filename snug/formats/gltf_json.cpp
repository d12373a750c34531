#include "snug/formats/gltf_json.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace snug::gltf {
namespace {

constexpr int kMostNesting = 128;
/// About 16 bytes of memory each, and some more for lists and names.
constexpr std::size_t kMostValues = 40'000'000;
constexpr double kMostWhole = 9007199254740992;  // 2^53

const Json kNothing;

/// How deep the text nests and how many values it has at most, without reading it: what it would take as a
/// tree is known before memory is asked for.
Result<void> check_size(std::string_view text) {
    int depth = 0;
    std::size_t values = 1;
    bool in_text = false, escaped = false;
    for (const char c : text) {
        if (in_text) {
            in_text = escaped || c != '"';
            escaped = !escaped && c == '\\';
            continue;
        }
        if (c == '"') in_text = true;
        if (c == ',' || c == '[' || c == '{') ++values;
        if (c == '[' || c == '{') ++depth;
        if (c == ']' || c == '}') --depth;
        if (depth > kMostNesting) return refuse(say("gltf.deep_json"));
    }
    if (values > kMostValues) return refuse(say("gltf.long_json", {{"most", kMostValues}}));
    return {};
}

/// How many bytes the UTF-8 sequence at the beginning has; 0 where it is none.
std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    const std::size_t length = first < 0x80   ? 1
                               : first < 0xC2 ? 0
                               : first < 0xE0 ? 2
                               : first < 0xF0 ? 3
                               : first < 0xF5 ? 4
                                              : 0;
    if (length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0) != 0x80) return 0;
    const bool overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
    const bool beyond = (first == 0xED && byte(1) > 0x9F) || (first == 0xF4 && byte(1) > 0x8F);
    return overlong || beyond ? 0 : length;
}

std::string as_utf8(std::string_view text) {
    std::string clean;
    clean.reserve(text.size());
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        if (length == 0) clean += "\xEF\xBF\xBD";
        clean += text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return clean;
}

}  // namespace

Result<Json> parse_scene(Bytes bytes) {
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
    while (!text.empty() && text.back() == '\0') text.remove_suffix(1);
    if (const auto size = check_size(text); !size) return tl::unexpected(size.error());
    Json scene = Json::parse(text.begin(), text.end(), nullptr, false);
    if (scene.is_discarded()) {
        const std::string clean = as_utf8(text);
        if (clean != text) scene = Json::parse(clean.begin(), clean.end(), nullptr, false);
    }
    if (!scene.is_object()) return refuse(say("gltf.no_json"));
    return scene;
}

const Json& field(const Json& of, const char* name) {
    if (!of.is_object()) return kNothing;
    const auto found = of.find(name);
    return found == of.end() ? kNothing : *found;
}

const Json& item(const Json& list, std::uint64_t index) {
    return index < count_of(list) ? list[static_cast<std::size_t>(index)] : kNothing;
}

std::uint64_t count_of(const Json& list) {
    return list.is_array() ? list.size() : 0;
}

const Json& extension(const Json& of, const char* name) {
    return field(field(of, "extensions"), name);
}

bool names(const Json& list, std::string_view name) {
    return list.is_array() && std::any_of(list.begin(), list.end(), [&](const Json& value) {
               return value.is_string() && value.get_ref<const std::string&>() == name;
           });
}

std::string text_of(const Json& of, const char* name, std::string_view otherwise) {
    const Json& value = field(of, name);
    return value.is_string() ? value.get<std::string>() : std::string(otherwise);
}

Result<std::uint64_t> whole_value(const Json& value, std::string_view name) {
    if (value.is_number_unsigned() && value.get<std::uint64_t>() <= static_cast<std::uint64_t>(kMostWhole))
        return value.get<std::uint64_t>();
    if (value.is_number_float()) {
        const double number = value.get<double>();
        if (number >= 0 && number <= kMostWhole && std::floor(number) == number)
            return static_cast<std::uint64_t>(number);
    }
    return refuse(say("gltf.no_whole_number", {{"name", name}}));
}

Result<std::uint64_t> whole(const Json& of, const char* name, std::uint64_t otherwise) {
    const Json& value = field(of, name);
    if (value.is_null()) return otherwise;
    return whole_value(value, name);
}

Result<void> numbers(const Json& of, const char* name, std::span<double> into) {
    const Json& list = field(of, name);
    if (list.is_null()) return {};
    bool good = count_of(list) == into.size();
    for (std::size_t i = 0; good && i < into.size(); ++i) {
        good = list[i].is_number();
        if (good) into[i] = list[i].get<double>();
    }
    if (good) return {};
    return refuse(say("gltf.no_list", {{"name", name}, {"numbers", std::to_string(into.size())}}));
}

}  // namespace snug::gltf
