#include "snug/design/option_json.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "snug/design/hand_edit_json.h"
#include "snug/design/json_reader.h"
#include "snug/design/zone_json.h"

namespace snug {
namespace {

using Json = nlohmann::json;
using Written = nlohmann::ordered_json;

struct Writing {
    const OptionRow& row;

    Written operator()(std::monostate) const { return nullptr; }
    Written operator()(const Vec2d* v) const { return Written::array({v->x, v->y}); }
    Written operator()(const CrossSection* v) const { return Written::array({v->width, v->length}); }
    template <class T>
    Written operator()(const Vec3<T>* v) const {
        return Written::array({v->x, v->y, v->z});
    }
    /// One number where all are equal, as older projects have it.
    Written operator()(const Walls* walls) const {
        return are_equal(*walls) ? Written(walls->front()) : Written(*walls);
    }
    Written operator()(const PartingLevels* levels) const {
        return levels->each.size() == 1 ? Written(levels->each.front()) : Written(levels->each);
    }
    Written operator()(const Clearance* clearance) const {
        const auto& [a, b] = *clearance;
        if (clearance->is_one()) return a.x;
        return Written::array({a.x, a.y, a.z, b.x, b.y, b.z});
    }
    Written operator()(const Weights* weights) const {
        Written json = Written::object();
        for (std::size_t i = 0; i < kObjectives; ++i)
            json[std::string(name_of(static_cast<Objective>(i)))] = (*weights)[i];
        return json;
    }
    Written operator()(const std::vector<BrickStock>* stock) const {
        Written json = Written::object();
        for (const BrickStock& each : *stock) json[each.size] = each.pieces;
        return json;
    }
    Written operator()(const std::vector<StressPoint>* points) const {
        Written json = Written::array();
        for (const StressPoint& each : *points) json.push_back({each.strain, each.kpa});
        return json;
    }
    Written operator()(const Zones* zones) const { return zones_json(*zones); }
    Written operator()(const HandEdits* edits) const { return edits_json(*edits); }
    Written operator()(const Choice& choice) const {
        const int at = choice.get();
        return at < 0 ? Written(nullptr) : Written(choice.words[static_cast<std::size_t>(at)]);
    }
    template <class T>
    Written operator()(const std::optional<T>* value) const {
        if (*value) return (*this)(&**value);
        return row.none.empty() ? Written(nullptr) : Written(row.none);
    }
    template <class T>
    Written operator()(const T* value) const {
        return *value;
    }
};

/// Reads a JSON value into an option's; false where it is something else.
struct Reading {
    const Json& json;
    const OptionRow& row;

    bool operator()(std::monostate) const { return json.is_null(); }
    bool operator()(bool* value) const {
        if (json.is_boolean()) *value = json.get<bool>();
        return json.is_boolean();
    }
    bool operator()(double* value) const {
        if (!json.is_number()) return false;
        *value = json.get<double>();
        return std::isfinite(*value);
    }
    bool operator()(int* value) const {
        if (!json.is_number_integer()) return false;
        if (json.is_number_unsigned() && json.get<std::uint64_t>() > std::numeric_limits<int>::max())
            return false;
        const auto wide = json.get<std::int64_t>();
        *value = static_cast<int>(wide);
        return wide >= std::numeric_limits<int>::min() && wide <= std::numeric_limits<int>::max();
    }
    bool operator()(std::uint32_t* value) const {
        int number = 0;
        if (!(*this)(&number) || number < 0) return false;
        *value = static_cast<std::uint32_t>(number);
        return true;
    }
    bool operator()(std::string* value) const {
        if (json.is_string()) *value = json.get<std::string>();
        return json.is_string();
    }
    bool operator()(Vec2d* v) const { return each({&v->x, &v->y}); }
    bool operator()(CrossSection* v) const { return each({&v->width, &v->length}); }
    bool operator()(StressPoint* v) const { return each({&v->strain, &v->kpa}); }
    bool operator()(std::vector<StressPoint>* value) const { return list(*value); }
    bool operator()(Zones* zones) const { return read_zones(json, *zones); }
    bool operator()(HandEdits* edits) const { return read_edits(json, *edits); }
    template <class T>
    bool operator()(Vec3<T>* v) const {
        return each({&v->x, &v->y, &v->z});
    }
    bool operator()(Plane* v) const { return each({&(*v)[0], &(*v)[1], &(*v)[2], &(*v)[3]}); }
    bool operator()(Walls* walls) const {
        double one = 0;
        if ((*this)(&one)) *walls = equal_walls(one);
        auto& w = *walls;
        return json.is_number() || each({&w[0], &w[1], &w[2], &w[3], &w[4], &w[5]});
    }
    bool operator()(Clearance* clearance) const {
        double one = 0;
        if ((*this)(&one)) *clearance = one;
        auto& [a, b] = *clearance;
        return json.is_number() || each({&a.x, &a.y, &a.z, &b.x, &b.y, &b.z});
    }
    bool operator()(PartingLevels* levels) const {
        levels->each.resize(1);
        return (*this)(levels->each.data()) || (list(levels->each) && !levels->each.empty());
    }
    bool operator()(std::vector<int>* value) const { return list(*value); }
    bool operator()(std::vector<std::string>* value) const { return list(*value); }
    bool operator()(Weights* weights) const {
        if (!json.is_object()) return false;
        for (const auto& [name, weight] : json.items()) {
            const auto objective = value_named<Objective>(name);
            if (!objective || !Reading{weight, row}(&(*weights)[static_cast<std::size_t>(*objective)]))
                return false;
        }
        return true;
    }
    bool operator()(std::vector<BrickStock>* stock) const {
        stock->clear();
        if (!json.is_object()) return false;
        for (const auto& [size, pieces] : json.items()) {
            stock->push_back({size, 0});
            if (!Reading{pieces, row}(&stock->back().pieces)) return false;
        }
        return true;
    }
    bool operator()(const Choice& choice) const {
        if (json.is_null()) {
            if (choice.may_be_none) choice.set(-1);
            return choice.may_be_none;
        }
        const auto word = json.is_string() ? json.get<std::string>() : std::string();
        const auto found = std::find(choice.words.begin(), choice.words.end(), word);
        if (found != choice.words.end()) choice.set(static_cast<int>(found - choice.words.begin()));
        return found != choice.words.end();
    }
    template <class T>
    bool operator()(std::optional<T>* value) const {
        const bool none = row.none.empty() ? json.is_null() : json == row.none;
        if (none) value->reset();
        return none || (*this)(&(*value ? **value : value->emplace()));
    }

  private:
    template <class T>
    bool each(std::initializer_list<T*> targets) const {
        if (!json.is_array() || json.size() != targets.size()) return false;
        std::size_t i = 0;
        return std::all_of(targets.begin(), targets.end(), [&](T* target) {
            return Reading{json[i++], row}(target);
        });
    }
    template <class T>
    bool list(std::vector<T>& target) const {
        if (!json.is_array()) return false;
        target.assign(json.size(), {});
        for (std::size_t i = 0; i < target.size(); ++i)
            if (!Reading{json[i], row}(&target[i])) return false;
        return true;
    }
};

/// What a field must be, as its refusal says it.
struct Expected {
    const OptionRow& row;

    Message operator()(std::monostate) const { return say("json.null"); }
    Message operator()(const bool*) const { return say("json.true_or_false"); }
    Message operator()(const int*) const { return say("takes.whole"); }
    Message operator()(const std::uint32_t*) const { return say("json.seed"); }
    Message operator()(const double*) const { return say("takes.number"); }
    Message operator()(const std::string*) const { return say("takes.text"); }
    Message operator()(const Vec2d*) const { return say("json.length_and_width"); }
    Message operator()(const CrossSection*) const { return say("json.width_and_length"); }
    Message operator()(const Vec3d*) const { return say("json.three"); }
    Message operator()(const Vec3i*) const { return say("json.three_whole"); }
    Message operator()(const Plane*) const { return say("json.four"); }
    Message operator()(const Walls*) const { return say("json.walls"); }
    Message operator()(const PartingLevels*) const { return say("json.levels"); }
    Message operator()(const Clearance*) const { return say("json.clearance"); }
    Message operator()(const Weights*) const {
        return say("json.weights", {{"words", each_as_it_is(names_of<Objective>())}});
    }
    Message operator()(const std::vector<int>*) const { return say("json.whole_list"); }
    Message operator()(const std::vector<std::string>*) const { return say("json.text_list"); }
    Message operator()(const std::vector<BrickStock>*) const { return say("json.pieces"); }
    Message operator()(const std::vector<StressPoint>*) const { return say("json.curve"); }
    Message operator()(const Zones*) const { return say("json.zones"); }
    Message operator()(const HandEdits*) const { return say("json.edits"); }
    Message operator()(const Choice& choice) const {
        std::vector<Message> words = each_as_it_is(choice.words);
        if (choice.may_be_none) words.push_back(as_it_is("null"));
        return say("takes.one_of", {{"words", words}});
    }
    template <class T>
    Message operator()(const std::optional<T>*) const {
        return say("takes.or", {{"what", (*this)(static_cast<const T*>(nullptr))},
                                {"none", row.none.empty() ? "null" : row.none}});
    }
};

using Problem = std::optional<Message>;

Problem read(const Json& json, const std::string& path, const OptionList& list, const std::string& prefix);

/// Structs of a list, in brackets; or each by its number, as --set names them.
Problem read_list(const Json& json, const std::string& path, const OptionList& list,
                  const std::string& prefix) {
    if (json.size() < 1 || json.size() > kMostItems)
        return must_be(prefix + path, say("json.items", {{"most", std::to_string(kMostItems)}}));
    for (std::size_t i = 0; i < json.size(); ++i)
        if (auto problem = read(json[i], path + "." + std::to_string(i), list, prefix)) return problem;
    return {};
}

Problem read_group(const Json& json, const std::string& path, const OptionList& list,
                   const std::string& prefix) {
    if (!json.is_object()) return not_an_object(path.empty() ? path : prefix + path);
    for (const auto& [name, value] : json.items())
        if (auto problem = read(value, path.empty() ? name : path + "." + name, list, prefix)) return problem;
    return {};
}

Problem read(const Json& json, const std::string& path, const OptionList& list, const std::string& prefix) {
    if (const Option* option = list.find(path)) {
        if (std::visit(Reading{json, option->row}, option->value)) return {};
        return must_be(prefix + path, std::visit(Expected{option->row}, option->value));
    }
    if (const OptionGroup* group = list.find_group(path)) {
        if (group->list && !json.is_object() && !json.is_array())
            return must_be(prefix + path, say("json.items", {{"most", std::to_string(kMostItems)}}));
        return group->list && json.is_array() ? read_list(json, path, list, prefix)
                                              : read_group(json, path, list, prefix);
    }
    return unknown_field(prefix + path);
}

/// The struct of this name or, in a list, of this number.
Written* within(Written& json, std::string_view name) {
    int number = 0;
    const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
    if (read.ptr == name.data() || read.ec != std::errc()) return &json[std::string(name)];
    return &json[static_cast<std::size_t>(number)];
}

}  // namespace

Written json_of(const Option& option) {
    return std::visit(Writing{option.row}, option.value);
}

Written json_of(const OptionList& list) {
    Written json = Written::object();
    for (const Option& option : list.options) {
        Written* at = &json;
        std::string_view rest = option.path;
        for (std::size_t dot; (dot = rest.find('.')) != std::string_view::npos; rest.remove_prefix(dot + 1))
            at = within(*at, rest.substr(0, dot));
        (*at)[std::string(rest)] = json_of(option);
    }
    return json;
}

std::optional<Message> read_options(const Json& json, const OptionList& list, const std::string& prefix) {
    return read_group(json, "", list, prefix);
}

std::optional<Message> read_options(const Json& json, Design& design, const std::string& prefix) {
    const auto presence = [&](const std::string& path) -> std::optional<bool> {
        std::string pointer = "/" + path;
        std::replace(pointer.begin(), pointer.end(), '.', '/');
        const Json::json_pointer at(pointer);
        if (!json.contains(at)) return {};
        return !json[at].is_null();
    };
    const auto length = [&](const std::string& path) -> std::optional<std::size_t> {
        const auto found = json.is_object() ? json.find(path) : json.end();
        if (found == json.end() || !found->is_array()) return {};
        return std::min<std::size_t>(found->size(), kMostItems);
    };
    return read_options(json, options_of(design, presence, length), prefix);
}

}  // namespace snug
