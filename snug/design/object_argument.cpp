#include "snug/design/object_argument.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "snug/base/text.h"
#include "snug/design/flags.h"
#include "snug/design/option_list.h"
#include "snug/design/option_text.h"
#include "snug/design/options_schema.h"

namespace snug {
namespace {

constexpr std::string_view kCount = "count", kUpright = "upright";
constexpr std::string_view kSwitches[] = {"cap", "lock"};  // need no value

template <class Options>
OptionList list_of(Options& options) {
    OptionList list;
    visit_options(list, options);
    return list;
}

/// What may be meant as a choice's name, also where no choice is called so.
bool is_word(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_' || c == ' ';
    });
}

bool is_switch(std::string_view text) {
    return std::find(std::begin(kSwitches), std::end(kSwitches), text) != std::end(kSwitches);
}

/// "part=4:15" goes on with a list of zones.
bool is_part(std::string_view text) {
    return text.starts_with("part=");
}

bool begins_a_choice(std::string_view text) {
    if (is_part(text)) return false;
    const std::size_t equals = text.find('=');
    return equals == std::string_view::npos ? is_switch(text) : is_word(text.substr(0, equals));
}

/// "a=1,b=2x3"; empty where it is something else. What begins no choice belongs to the one before, comma
/// included: a name, or a vector as it is typed elsewhere.
std::vector<std::pair<std::string, std::string>> choices_of(std::string_view text) {
    std::vector<std::pair<std::string, std::string>> choices;
    for (bool more = true; more;) {
        const std::size_t end = std::min(text.find(','), text.size());
        more = end < text.size();
        const std::string_view one = text.substr(0, end);
        const std::size_t equals = std::min(one.find('='), one.size());
        if (begins_a_choice(one))
            choices.emplace_back(one.substr(0, equals), one.substr(std::min(equals + 1, one.size())));
        else if (choices.empty())
            return {};
        else
            choices.back().second.append(",").append(one);
        text.remove_prefix(more ? end + 1 : text.size());
    }
    return choices;
}

/// Vectors are written with x here, since commas part the choices; as they are typed elsewhere they do, too.
Result<void> take(Option option, const std::string& text) {
    OptionRow& row = option.row;
    row.flag = row.word.empty() ? row.flag.substr(2) : row.word;  // what a refusal names
    auto done = take_text(option, text);
    for (const auto& [from, to] : {std::pair('x', ','), std::pair(',', 'x')}) {
        if (done) return done;
        std::string other = text;
        std::replace(other.begin(), other.end(), from, to);
        if (take_text(option, other)) return {};
    }
    return done;
}

const Option* find_word(const OptionList& list, std::string_view word) {
    const auto found = std::find_if(list.options.begin(), list.options.end(),
                                    [&](const Option& option) { return option.row.word == word; });
    return found == list.options.end() ? nullptr : &*found;
}

/// The turn that lets an axis of the file point up.
std::optional<Vec3d> upright(std::string_view axis) {
    if (axis == "x") return Vec3d{};
    if (axis == "-x") return Vec3d{0, 180, 0};
    if (axis == "y") return Vec3d{0, 0, -90};
    if (axis == "-y") return Vec3d{0, 0, 90};
    if (axis == "z") return Vec3d{0, 90, 0};
    if (axis == "-z") return Vec3d{0, -90, 0};
    return {};
}

struct Taken {
    ItemOptions item;
    std::optional<ObjectOptions> own;
    int count = 1;
    std::optional<Upright> upright;
};

std::vector<Message> known_choices(const OptionList& item, const OptionList& object) {
    std::vector<Message> names{as_it_is(kCount), as_it_is(kUpright)};
    for (const OptionList* list : {&item, &object})
        for (const Option& option : list->options) {
            const OptionRow& row = option.row;
            if (!row.word.empty()) names.push_back(as_it_is(row.word));
            if (row.flag.size() > 2) names.push_back(as_it_is(row.flag.substr(2)));
        }
    return names;
}

Result<void> take_choice(const std::string& name, const std::string& text, const Design& design,
                         Taken& taken) {
    if (name == kCount) {
        const auto count = typed_integer(text);
        if (!count || *count < 1 || *count > kMostItems)
            return not_what_it_takes(name, say("takes.count", {{"most", std::to_string(kMostItems)}}), text);
        taken.count = *count;
        return {};
    }
    if (name == kUpright) {
        taken.item.rotation_deg = upright(text);
        taken.upright = value_named<Upright>(text);
        if (!taken.item.rotation_deg) return not_what_it_takes(name, say("takes.axis"), text);
        return {};
    }
    const OptionList of_item = list_of(taken.item);
    if (const Option* option = find_word(of_item, name)) return take(*option, text);
    ObjectOptions own = taken.own.value_or(design.object);
    const OptionList of_object = list_of(own);
    const Option* const option = of_object.find_by_flag("--" + name);
    if (!option)
        return fail(ErrorKind::usage,
                    say("object.no_choice", {{"name", name}, {"names", known_choices(of_item, of_object)}}));
    if (auto done = take(*option, text); !done) return done;
    taken.own = own;
    return {};
}

Result<Taken> take_choices(const ObjectArgument& argument, const ItemOptions& usual, const Design& design) {
    Taken taken{usual, {}, 1, {}};
    for (auto at = argument.choices.begin(); at != argument.choices.end(); ++at) {
        const auto same = [&](const auto& each) { return each.first == at->first; };
        if (std::any_of(argument.choices.begin(), at, same))
            return fail(ErrorKind::usage, say("object.twice", {{"name", at->first}}));
        if (auto done = take_choice(at->first, at->second, design, taken); !done)
            return tl::unexpected(done.error());
    }
    const auto chosen = [&](std::string_view name) {
        return std::any_of(argument.choices.begin(), argument.choices.end(),
                           [&](const auto& each) { return each.first == name; });
    };
    if (chosen(kUpright) && chosen("rotate"))
        return fail(ErrorKind::usage, say("object.turned_twice", {{"one", "rotate"}, {"other", kUpright}}));
    if (const auto found = out_of_range(taken.item)) return fail(ErrorKind::usage, found->message);
    if (auto wrong = problem_of(taken.item.zones)) return fail(ErrorKind::usage, std::move(*wrong));
    if (taken.own)
        if (const auto found = problem_of(*taken.own)) return fail(ErrorKind::usage, found->message);
    return taken;
}

std::size_t object_of(Project& project, std::vector<std::string>& files, const std::string& file,
                      const std::optional<ObjectOptions>& own) {
    for (std::size_t i = 0; i < files.size(); ++i)
        if (files[i] == file && project.objects[i].own == own) return i;
    files.push_back(file);
    ProjectObject object;
    object.own = own;
    project.objects.push_back(std::move(object));
    return files.size() - 1;
}

/// ",mass=0.6,move=0x40x0": what `options` say other than `usual`.
template <class Options>
std::string typed_choices(Options options, Options usual) {
    const OptionList list = list_of(options), untouched = list_of(usual);
    std::string typed;
    for (std::size_t i = 0; i < list.options.size(); ++i) {
        const Option& option = list.options[i];
        const OptionRow& row = option.row;
        const std::string word(row.word.empty() ? row.flag.substr(std::min<std::size_t>(2, row.flag.size()))
                                                : row.word);
        auto text = text_of(option);
        if (word.empty() || !text || text == text_of(untouched.options[i])) continue;
        const bool is_text = kind_of(option) == "text";
        if (is_text && text->find(':') != std::string::npos) continue;
        if (!is_text) std::replace(text->begin(), text->end(), ',', 'x');
        typed += "," + word + (text->empty() ? "" : "=" + *text);
    }
    return typed;
}

}  // namespace

ObjectArgument object_argument(std::string_view text) {
    // The first colon behind which choices stand: some have colons themselves.
    for (std::size_t colon = text.find(':', 1); colon < text.size(); colon = text.find(':', colon + 1)) {
        auto choices = choices_of(text.substr(colon + 1));
        // "C:name" is a file of another system.
        const bool any = std::any_of(choices.begin(), choices.end(), [](const auto& each) {
            return !each.second.empty() || is_switch(each.first);
        });
        if (any) return {std::string(text.substr(0, colon)), std::move(choices)};
    }
    return {std::string(text), {}};
}

Result<Project> with_objects(std::span<const ObjectArgument> arguments, Design design,
                             std::vector<std::string>& files) {
    Project project;
    project.objects.clear();
    files.clear();
    // What --set says of the first item.
    const ItemOptions first = design.items.front();
    design.items.clear();
    for (const ObjectArgument& argument : arguments) {
        auto taken = take_choices(argument, design.items.empty() ? first : ItemOptions(), design);
        if (!taken) return fail(taken.error().kind, in_file(argument.file, taken.error().message));
        taken->item.object = static_cast<int>(object_of(project, files, argument.file, taken->own));
        if (design.items.size() + static_cast<std::size_t>(taken->count) > kMostItems)
            return fail(
                ErrorKind::usage,
                in_file(argument.file, say("object.too_many", {{"most", std::to_string(kMostItems)}})));
        design.items.insert(design.items.end(), static_cast<std::size_t>(taken->count), taken->item);
        // Of one item a search, too, must know it; several are not searched.
        const bool alone = arguments.size() == 1 && taken->count == 1;
        if (alone && taken->upright) design.search.upright = taken->upright;
    }
    project.design = std::move(design);
    return project;
}

std::vector<std::string> typed_items(const Project& project, std::span<const std::string> files) {
    std::vector<std::string> typed;
    const std::vector<ItemOptions>& items = project.design.items;
    for (std::size_t i = 0, end = 0; i < items.size(); i = end) {
        while (end < items.size() && items[end] == items[i]) ++end;
        const auto object = static_cast<std::size_t>(items[i].object);
        const auto& own = project.objects[object].own;
        std::string choices = end - i > 1 ? ",count=" + std::to_string(end - i) : "";
        choices += typed_choices(items[i], ItemOptions());
        if (own) choices += typed_choices(*own, project.design.object);
        typed.push_back(files[object] + (choices.empty() ? "" : ":" + choices.substr(1)));
    }
    return typed;
}

bool wants_arrangement(const Design& design) {
    return design.items.size() > 1 && std::any_of(design.items.begin(), design.items.end(),
                                                  [](const ItemOptions& item) { return !item.offset_mm; });
}

}  // namespace snug
