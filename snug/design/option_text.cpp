#include "snug/design/option_text.h"

#include <algorithm>
#include <charconv>
#include <initializer_list>

#include <fast_float/fast_float.h>
#include <nlohmann/json.hpp>

#include "snug/base/text.h"

namespace snug {
namespace {

constexpr int kMostParts = 100'000;  // that one --drop names

template <class T>
bool in_three(std::string_view text, char separator, Vec3<T>& target) {
    const std::vector<double> values = typed_numbers(text, separator);
    if (values.size() != 3) return false;
    for (int axis = 0; axis < 3; ++axis) {
        target[axis] = static_cast<T>(values[static_cast<std::size_t>(axis)]);
        if (static_cast<double>(target[axis]) != values[static_cast<std::size_t>(axis)] &&
            std::is_integral_v<T>)
            return false;
    }
    return true;
}

std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> words;
    for (bool more = true; more;) {
        const std::size_t end = text.find(',');
        more = end != std::string_view::npos;
        words.push_back(text.substr(0, end));
        text.remove_prefix(more ? end + 1 : text.size());
    }
    return words;
}

/// "5-9" or "2", from 1 upward
bool add_range(std::string_view word, std::vector<int>& numbers) {
    const std::size_t dash = word.find('-');
    const auto first = typed_integer(word.substr(0, dash));
    const auto last = dash == std::string_view::npos ? first : typed_integer(word.substr(dash + 1));
    if (!first || !last || *first < 1 || *last < *first ||
        *last - *first >= kMostParts - static_cast<int>(numbers.size()))
        return false;
    for (int number = *first; number <= *last; ++number) numbers.push_back(number);
    return true;
}

/// Reads a text into the value that an option has; false where it is something else.
struct Taking {
    std::string_view text;
    const OptionRow& row;

    bool operator()(std::monostate) const { return false; }
    bool operator()(bool* value) const {
        *value = text != "no";
        return text.empty() || text == "yes" || text == "no";
    }
    bool operator()(int* value) const { return number(typed_integer(text), *value); }
    bool operator()(double* value) const { return number(typed_number(text), *value); }
    bool operator()(std::uint32_t* value) const {
        const auto typed = typed_integer(text);
        if (typed && *typed >= 0) *value = static_cast<std::uint32_t>(*typed);
        return typed && *typed >= 0;
    }
    bool operator()(std::string* value) const {
        *value = text;
        return true;
    }
    bool operator()(Vec2d* value) const {
        const auto values = typed_numbers(text, row.separator);
        if (values.size() == 2) *value = {values[0], values[1]};
        return values.size() == 2;
    }
    bool operator()(Vec3d* value) const { return in_three(text, row.separator, *value); }
    bool operator()(Vec3i* value) const { return in_three(text, row.separator, *value); }
    bool operator()(CrossSection* value) const {
        const auto values = typed_numbers(text, row.separator);
        if (values.size() == 2) *value = {values[1], values[0]};
        return values.size() == 2;
    }
    bool operator()(Clearance* value) const {
        const auto v = typed_numbers(text, ',');
        if (v.size() == 1) *value = v[0];
        if (v.size() == 3) *value = {{v[0], v[1], v[2]}, {v[0], v[1], v[2]}};
        if (v.size() == 6) *value = {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
        return v.size() == 1 || v.size() == 3 || v.size() == 6;
    }
    bool operator()(PartingLevels* levels) const {
        levels->each.clear();
        for (const std::string_view word : words_of(text)) {
            const auto level = typed_integer(word);
            if (!level) return false;
            levels->each.push_back(*level);
        }
        return true;
    }
    bool operator()(Walls* value) const {
        const auto v = typed_numbers(text, ',');
        if (v.size() == 1) *value = equal_walls(v[0]);
        if (v.size() == 3) *value = paired_walls({v[0], v[1], v[2]});
        if (v.size() == 6) *value = {v[0], v[1], v[2], v[3], v[4], v[5]};
        return v.size() == 1 || v.size() == 3 || v.size() == 6;
    }
    bool operator()(Plane* value) const {
        const auto v = typed_numbers(text, ',');
        if (v.size() == 4) *value = {v[0], v[1], v[2], v[3]};
        return v.size() == 4;
    }
    bool operator()(std::vector<int>* value) const {
        value->clear();
        for (const std::string_view word : words_of(text))
            if (!add_range(word, *value)) return false;
        return true;
    }
    bool operator()(std::vector<std::string>* value) const {
        value->clear();
        for (const std::string_view word : words_of(text)) value->emplace_back(word);
        return true;
    }
    bool operator()(std::vector<BrickStock>* value) const {
        value->clear();
        for (const std::string_view word : words_of(text)) {
            const std::size_t equals = std::min(word.find('='), word.size());
            const auto pieces = typed_integer(word.substr(std::min(equals + 1, word.size())));
            if (!pieces) return false;
            value->push_back({std::string(word.substr(0, equals)), *pieces});
        }
        return true;
    }
    /// "0.25:40,0.4:75"
    bool operator()(std::vector<StressPoint>* value) const {
        value->clear();
        for (const std::string_view word : words_of(text)) {
            const auto pair = typed_numbers(word, ':');
            if (pair.size() != 2) return false;
            value->push_back({pair[0], pair[1]});
        }
        return true;
    }
    bool operator()(Zones* value) const {
        auto zones = text == "none" ? Zones() : typed_zones(text);
        if (zones) *value = std::move(*zones);
        return zones.has_value();
    }
    bool operator()(HandEdits* value) const {
        auto edits = text == "none" ? HandEdits() : typed_edits(text);
        if (edits) *value = std::move(*edits);
        return edits.has_value();
    }
    /// "cut=1,bearing=0.5"; a name alone weighs 1.
    bool operator()(Weights* value) const {
        value->fill(0);
        for (const std::string_view word : words_of(text)) {
            const std::size_t equals = word.find('=');
            const auto objective = value_named<Objective>(word.substr(0, equals));
            const auto weight = equals == std::string_view::npos ? std::optional<double>(1)
                                                                 : typed_number(word.substr(equals + 1));
            if (!objective || !weight) return false;
            (*value)[static_cast<std::size_t>(*objective)] = *weight;
        }
        return true;
    }
    bool operator()(const Choice& choice) const {
        const auto found = std::find(choice.words.begin(), choice.words.end(), text);
        const bool none = choice.may_be_none && is_none();
        if (found != choice.words.end() || none)
            choice.set(none ? -1 : static_cast<int>(found - choice.words.begin()));
        return found != choice.words.end() || none;
    }
    template <class T>
    bool operator()(std::optional<T>* value) const {
        value->reset();
        return is_none() || (*this)(&value->emplace());
    }

  private:
    [[nodiscard]] bool is_none() const { return text == (row.none.empty() ? "none" : row.none); }
    template <class T>
    static bool number(const std::optional<T>& typed, T& value) {
        if (typed) value = *typed;
        return typed.has_value();
    }
};

/// What a flag takes, as its refusal says it.
struct Takes {
    const OptionRow& row;

    Message operator()(std::monostate) const { return say("takes.nothing"); }
    Message operator()(const bool*) const { return say("takes.nothing"); }
    Message operator()(const int*) const { return say("takes.whole"); }
    Message operator()(const std::uint32_t*) const { return say("takes.whole_from_0"); }
    Message operator()(const double*) const {
        return row.unit.empty() ? say("takes.number") : say("takes.number_of", {{"unit", said(row.unit)}});
    }
    Message operator()(const std::string*) const { return say("takes.text"); }
    Message operator()(const Vec2d*) const { return say("takes.two_lengths", {{"example", "1000x600"}}); }
    Message operator()(const CrossSection*) const {
        return say("takes.length_and_width", {{"example", "410x270"}});
    }
    Message operator()(const Vec3i*) const { return say("takes.three_numbers", {{"example", "30x18x18"}}); }
    Message operator()(const Vec3d*) const {
        return say("takes.three_numbers", {{"example", row.separator == 'x' ? "15x15x22" : "0,90,0"}});
    }
    Message operator()(const Clearance*) const {
        return say("takes.clearance", {{"example", "1"}, {"other", "0,2,2"}});
    }
    Message operator()(const PartingLevels*) const {
        return say("takes.levels", {{"example", "5"}, {"other", "5,12"}});
    }
    Message operator()(const Walls*) const {
        return say("takes.walls", {{"example", "50"}, {"other", "40,50,50"}});
    }
    Message operator()(const Plane*) const { return say("takes.plane", {{"example", "0,0,1,12"}}); }
    Message operator()(const std::vector<int>*) const { return say("takes.ranges", {{"example", "2,5-9"}}); }
    Message operator()(const std::vector<std::string>*) const {
        return say("takes.words", {{"example", row.takes}});
    }
    Message operator()(const std::vector<BrickStock>*) const {
        return say("takes.pieces", {{"example", "2x4=100,1x1=40"}});
    }
    Message operator()(const std::vector<StressPoint>*) const {
        return say("takes.curve", {{"example", "0.25:40,0.4:75"}});
    }
    Message operator()(const Zones*) const {
        return say("takes.zones", {{"example", "part=3:15"}, {"other", "10,20,30,25:15"}});
    }
    Message operator()(const HandEdits*) const {
        return say("takes.edits", {{"example", "lower:12:7:1"}, {"other", "upper:12:7:-2"}});
    }
    Message operator()(const Weights*) const {
        return say("takes.weights",
                   {{"words", each_as_it_is(names_of<Objective>())}, {"example", "cut=1,bearing=0.5"}});
    }
    Message operator()(const Choice& choice) const {
        std::vector<Message> words = each_as_it_is(choice.words);
        if (choice.may_be_none) words.push_back(as_it_is(none()));
        return say("takes.one_of", {{"words", words}});
    }
    template <class T>
    Message operator()(const std::optional<T>* value) const {
        return say("takes.or",
                   {{"what", (*this)(value->has_value() ? &**value : static_cast<const T*>(nullptr))},
                    {"none", none()}});
    }

  private:
    [[nodiscard]] std::string_view none() const { return row.none.empty() ? "none" : row.none; }
};

using Text = std::optional<std::string>;

/// What Taking reads back.
struct Saying {
    const OptionRow& row;

    Text operator()(std::monostate) const { return {}; }
    Text operator()(const bool* value) const { return *value ? Text("") : Text(); }
    Text operator()(const int* value) const { return std::to_string(*value); }
    Text operator()(const std::uint32_t* value) const { return std::to_string(*value); }
    Text operator()(const double* value) const { return exact(*value); }
    Text operator()(const std::string* value) const { return *value; }
    Text operator()(const Vec2d* v) const { return exact({v->x, v->y}, row.separator); }
    Text operator()(const CrossSection* v) const { return exact({v->length, v->width}, row.separator); }
    Text operator()(const Vec3d* v) const { return exact({v->x, v->y, v->z}, row.separator); }
    Text operator()(const Vec3i* v) const { return (*this)(Vec3d(vec_cast<double>(*v))); }
    Text operator()(const Vec3d& v) const { return (*this)(&v); }
    Text operator()(const Clearance* clearance) const {
        const auto& [a, b] = *clearance;
        if (clearance->is_one()) return exact(a.x);
        if (clearance->same_in_both()) return exact({a.x, a.y, a.z}, ',');
        return exact({a.x, a.y, a.z, b.x, b.y, b.z}, ',');
    }
    Text operator()(const PartingLevels* levels) const { return (*this)(&levels->each); }
    Text operator()(const Walls* walls) const {
        const auto& w = *walls;
        return are_equal(w) ? exact(w[0]) : exact({w[0], w[1], w[2], w[3], w[4], w[5]}, ',');
    }
    Text operator()(const Plane* p) const { return exact({(*p)[0], (*p)[1], (*p)[2], (*p)[3]}, ','); }
    Text operator()(const std::vector<int>* value) const {
        return joined(*value, [](int each) { return std::to_string(each); });
    }
    Text operator()(const std::vector<std::string>* value) const {
        return joined(*value, [](const std::string& each) { return each; });
    }
    Text operator()(const std::vector<BrickStock>* value) const {
        return joined(*value,
                      [](const BrickStock& each) { return each.size + "=" + std::to_string(each.pieces); });
    }
    Text operator()(const std::vector<StressPoint>* value) const {
        return joined(*value, [](const StressPoint& each) { return exact({each.strain, each.kpa}, ':'); });
    }
    Text operator()(const Zones* value) const { return snug::text_of(*value).value_or("none"); }
    Text operator()(const HandEdits* value) const { return snug::text_of(*value).value_or("none"); }
    Text operator()(const Weights* value) const {
        std::vector<std::string> words;
        for (std::size_t i = 0; i < kObjectives; ++i)
            if ((*value)[i] != 0)
                words.push_back(std::string(name_of(static_cast<Objective>(i))) +
                                ((*value)[i] == 1 ? "" : "=" + exact((*value)[i])));
        return (*this)(&words);
    }
    Text operator()(const Choice& choice) const {
        const int at = choice.get();
        return at < 0 ? none() : std::string(choice.words[static_cast<std::size_t>(at)]);
    }
    template <class T>
    Text operator()(const std::optional<T>* value) const {
        return *value ? (*this)(&**value) : none();
    }

  private:
    [[nodiscard]] std::string none() const { return row.none.empty() ? "none" : std::string(row.none); }
    /// An empty list cannot be typed.
    template <class List, class ToText>
    static Text joined(const List& list, ToText to_text) {
        Text text;
        for (const auto& each : list) text = text ? *text + "," + to_text(each) : to_text(each);
        return text;
    }
};

}  // namespace

std::optional<double> typed_number(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = fast_float::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) return {};
    return value;
}

std::optional<int> typed_integer(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    int value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) return {};
    return value;
}

std::vector<double> typed_numbers(std::string_view text, char separator) {
    std::vector<double> values;
    for (bool more = true; more;) {
        const std::size_t end = text.find(separator);
        more = end != std::string_view::npos;
        const auto value = typed_number(text.substr(0, end));
        if (!value) return {};
        values.push_back(*value);
        text.remove_prefix(more ? end + 1 : text.size());
    }
    return values;
}

std::string exact(double value) {
    std::string text = nlohmann::json(value).dump();
    if (text.size() > 2 && text.ends_with(".0")) text.resize(text.size() - 2);
    return text == "-0" ? "0" : text;
}

std::string exact(std::initializer_list<double> values, char separator) {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : std::string(1, separator)) + exact(value);
    return text;
}

Result<void> take_text(const Option& option, std::string_view text) {
    if (std::visit(Taking{text, option.row}, option.value)) return {};
    return not_what_it_takes(option.row.flag, std::visit(Takes{option.row}, option.value), text);
}

std::optional<std::string> text_of(const Option& option) {
    return std::visit(Saying{option.row}, option.value);
}

tl::unexpected<Error> not_what_it_takes(std::string_view flag, Message what, std::string_view text) {
    return fail(ErrorKind::usage,
                say("takes", {{"flag", flag}, {"what", std::move(what)}, {"found", quoted(text)}}));
}

}  // namespace snug
