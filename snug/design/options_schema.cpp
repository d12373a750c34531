#include "snug/design/options_schema.h"

#include <nlohmann/json.hpp>

#include "snug/design/option_json.h"

namespace snug {
namespace {

using Json = nlohmann::ordered_json;

struct Kind {
    std::string_view operator()(std::monostate) const { return "missing"; }
    std::string_view operator()(const bool*) const { return "switch"; }
    std::string_view operator()(const int*) const { return "integer"; }
    std::string_view operator()(const std::uint32_t*) const { return "integer"; }
    std::string_view operator()(const double*) const { return "number"; }
    std::string_view operator()(const std::string*) const { return "text"; }
    std::string_view operator()(const Vec3i*) const { return "integers"; }
    std::string_view operator()(const std::vector<int>*) const { return "integers"; }
    std::string_view operator()(const std::vector<std::string>*) const { return "words"; }
    std::string_view operator()(const std::vector<BrickStock>*) const { return "pieces"; }
    std::string_view operator()(const Weights*) const { return "weights"; }
    std::string_view operator()(const Choice&) const { return "word"; }
    template <class T>
    std::string_view operator()(const std::optional<T>*) const {
        return (*this)(static_cast<const T*>(nullptr));
    }
    /// Vectors, walls, clearances and all else that is a few numbers.
    template <class T>
    std::string_view operator()(const T*) const {
        return "numbers";
    }
};

struct MayBeNone {
    bool operator()(const Choice& choice) const { return choice.may_be_none; }
    template <class T>
    bool operator()(const std::optional<T>*) const {
        return true;
    }
    template <class T>
    bool operator()(const T&) const {
        return false;
    }
};

Json described(const Option& option) {
    const OptionRow& row = option.row;
    Json json{{"kind", kind_of(option)}, {"label", row.label.english}, {"help", row.help.english}};
    if (!row.unit.empty()) json["unit"] = row.unit.english;
    if (!row.range.any()) {
        json["least"] = row.range.least;
        json["most"] = row.range.most;
        if (row.range.above) json["above"] = true;
        if (row.range.or_zero) json["or_zero"] = true;
    }
    if (row.step > 0) json["step"] = row.step;
    if (const auto* choice = std::get_if<Choice>(&option.value)) json["words"] = choice->words;
    if (!row.words.empty()) json["words"] = row.words;
    if (std::visit(MayBeNone{}, option.value)) json["optional"] = true;
    json["default"] = json_of(option);
    if (!row.flag.empty()) json["flag"] = row.flag;
    json["scope"] = name_of(row.scope);
    return json;
}

}  // namespace

std::string_view kind_of(const Option& option) {
    return std::visit(Kind{}, option.value);
}

std::string options_schema() {
    Design design;
    Json json = Json::object();
    for (const Option& option : all_options(design).options) json[option.path] = described(option);
    return json.dump();
}

}  // namespace snug
