#include "snug/design/options_schema.h"

#include <nlohmann/json.hpp>

#include "snug/design/option_json.h"

namespace snug {
namespace {

using OrderedJson = nlohmann::ordered_json;

struct Kind {
    std::string_view operator()(std::monostate) const { return "missing"; }
    std::string_view operator()(const bool*) const { return "switch"; }
    std::string_view operator()(const int*) const { return "integer"; }
    std::string_view operator()(const std::uint32_t*) const { return "integer"; }
    std::string_view operator()(const double*) const { return "number"; }
    std::string_view operator()(const std::string*) const { return "text"; }
    std::string_view operator()(const Vec3i*) const { return "integers"; }
    std::string_view operator()(const std::vector<int>*) const { return "integers"; }
    std::string_view operator()(const PartingLevels*) const { return "levels"; }
    std::string_view operator()(const std::vector<std::string>*) const { return "words"; }
    std::string_view operator()(const std::vector<BrickStock>*) const { return "pieces"; }
    std::string_view operator()(const std::vector<StressPoint>*) const { return "curve"; }
    std::string_view operator()(const Zones*) const { return "zones"; }
    std::string_view operator()(const HandEdits*) const { return "edits"; }
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

/// How many numbers there are; 0: any number of them, or no numbers.
struct Count {
    int operator()(const Vec2d*) const { return 2; }
    int operator()(const Vec3d*) const { return 3; }
    int operator()(const CrossSection*) const { return 2; }
    int operator()(const Plane*) const { return 4; }
    int operator()(const Clearance*) const { return 6; }
    int operator()(const Walls*) const { return 6; }
    int operator()(const std::optional<Vec3i>*) const { return 3; }
    template <class T>
    int operator()(const std::optional<T>*) const {
        return (*this)(static_cast<const T*>(nullptr));
    }
    template <class T>
    int operator()(const T*) const {
        return 0;
    }
    int operator()(std::monostate) const { return 0; }
    int operator()(const Choice&) const { return 0; }
};

/// Whether one number may stand for all of them.
bool may_be_one(const Option& option) {
    return std::holds_alternative<Clearance*>(option.value) ||
           std::holds_alternative<std::optional<Clearance>*>(option.value) ||
           std::holds_alternative<std::optional<Walls>*>(option.value);
}

struct MayBeNone {
    bool operator()(const Choice& choice) const { return choice.may_be_none; }
    template <class T>
    bool operator()(const std::optional<T>*) const {
        return true;
    }
    template <class T>
    bool operator()(const T*) const {
        return false;
    }
    bool operator()(std::monostate) const { return true; }
};

/// English, Japanese.
OrderedJson in_both(const Words& words) {
    return OrderedJson::array({words.english, words.japanese});
}

OrderedJson described(const Option& option) {
    const OptionRow& row = option.row;
    OrderedJson json{{"kind", kind_of(option)}, {"label", in_both(row.label)}, {"help", in_both(row.help)}};
    if (!row.unit.empty()) json["unit"] = row.unit.english;
    if (!row.range.any()) {
        json["least"] = row.range.least;
        json["most"] = row.range.most;
        if (row.range.above) json["above"] = true;
        if (row.range.or_zero) json["or_zero"] = true;
    }
    if (row.step > 0) json["step"] = row.step;
    if (row.often > 0) json["often"] = row.often;
    if (const int count = count_of(option); count > 0) json["count"] = count;
    if (may_be_one(option)) json["or_one"] = true;
    if (const auto* choice = std::get_if<Choice>(&option.value)) json["words"] = choice->words;
    if (!row.words.empty()) json["words"] = row.words;
    if (std::visit(MayBeNone{}, option.value)) {
        json["optional"] = true;
        const bool word = std::holds_alternative<Choice>(option.value);
        if (!word && !row.none.empty()) json["none"] = row.none;
    }
    json["default"] = json_of(option);
    if (!row.flag.empty()) json["flag"] = row.flag;
    json["scope"] = name_of(row.scope);
    return json;
}

}  // namespace

std::string_view kind_of(const Option& option) {
    return std::visit(Kind{}, option.value);
}

int count_of(const Option& option) {
    return std::visit(Count{}, option.value);
}

std::string options_schema() {
    Design design;
    const OptionList list = all_options(design);
    OrderedJson json = OrderedJson::object();
    for (const OptionGroup& group : list.groups)
        if (group.list)
            json[group.path] = {{"kind", "list"}, {"label", in_both(group.row.title)}};
        else if (group.optional)
            json[group.path] = {{"kind", "group"}, {"label", in_both(group.row.title)}, {"optional", true}};
    for (const Option& option : list.options) json[option.path] = described(option);
    SpaceOptions fitted;
    fitted.blocks.reset();
    json["space.wall_mm"]["fitted"] = wanted_wall_mm(fitted).front();
    fitted.open = 1;
    json["space.wall_mm"]["tray"] = wanted_wall_mm(fitted).front();
    return json.dump();
}

std::string dependent_options(const Design& design) {
    const double depth = design.space.block_mm.x;
    const WorkshopOptions& workshop = design.workshop;
    return OrderedJson{
        {"cut.clearance_mm", {{"least", least_clearance_mm(design.space.block_mm)}}},
        {"parting.level", {{"most", highest_parting(design)}}},
        {"workshop.sheets.thickness_mm", {{"usual", wanted_thickness_mm(workshop.sheets, depth)}}},
        {"workshop.mill.step_down_mm", {{"usual", wanted_step_down_mm(workshop.mill)}}}}
        .dump();
}

}  // namespace snug
