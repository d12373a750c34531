#include "snug/design/command_line.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "snug/design/object_argument.h"
#include "snug/design/option_json.h"
#include "snug/design/option_text.h"

namespace snug {
namespace {

/// Looks for flags that lead from an untouched design to the one that is wanted.
class Telling {
  public:
    Telling(const Design& wanted, const KnownNames& known) : wanted_(wanted), known_(known) {
        (void)renew();
        take_foam();
        for (const Flag& flag : design_flags())
            if (flag.name != "--preset" && flag.name != "--for" && flag.name != "--foam" &&
                flag.name != "--set")
                tell(flag);
        tell_rest();
    }

    Telling(const Telling&) = delete;
    Telling& operator=(const Telling&) = delete;

    [[nodiscard]] std::vector<TypedFlag> typed() && { return std::move(typed_); }

  private:
    /// A way of working implies a foam of its own unless one is named.
    void take_foam() {
        const Workshop work = wanted_.workshop.work;
        if (work != Workshop::none) (void)add({"--for", std::string(name_of(work))});
        if (wanted_.space.preset != told_.space.preset) (void)add({"--preset", wanted_.space.preset});
        if (wanted_.protection.foam) (void)add({"--foam", wanted_.protection.foam->name});
    }

    void tell(const Flag& flag) {
        // A case takes no counts.
        const bool cased = wanted_.case_options.inside_mm.has_value();
        if (flag.name == "--blocks" && cased && wanted_.space.blocks) return;
        if (!differs(flag.name)) return;
        if (flag.name == "--case" && tell_case()) return;
        const BoundFlag* const shared = list_.find_flag(flag.name);
        const auto text = shared ? shared->say() : text_of(*list_.find_by_flag(flag.name));
        if (text) (void)add({flag.name, *text});
    }

    /// By its name where that gives the case, else by its sizes.
    bool tell_case() {
        const CaseOptions& wanted = wanted_.case_options;
        if (!wanted.inside_mm) return true;
        if (!wanted.name.empty() && add({"--case", wanted.name})) {
            const CaseOptions& got = told_.case_options;
            if (got.inside_mm == wanted.inside_mm && got.lid_mm == wanted.lid_mm) return true;
            typed_.pop_back();
            (void)renew();
        }
        Design nameless = wanted_;
        nameless.case_options.name.clear();
        const auto text = options_of(nameless).find_flag("--case")->say();
        return text && add({"--case", *text});
    }

    /// What no flag says.
    void tell_rest() {
        for (const Option& option : list_.options)
            if (!is_told(option))
                (void)add({"--set", option.path + "=" +
                                        json_of(option).dump(-1, ' ', false,
                                                             nlohmann::json::error_handler_t::replace)});
    }

    [[nodiscard]] bool is_told(const Option& option) const {
        const Option* const so_far = told_list_.find(option.path);
        return so_far && json_of(*so_far) == json_of(option);
    }

    /// Whether an option that the flag says is not yet what it must be.
    [[nodiscard]] bool differs(std::string_view flag) const {
        return std::any_of(list_.options.begin(), list_.options.end(),
                           [&](const Option& option) { return option.row.flag == flag && !is_told(option); });
    }

    /// Keeps the flag where it can be read.
    bool add(TypedFlag flag) {
        typed_.push_back(std::move(flag));
        if (renew()) return true;
        typed_.pop_back();
        return false;
    }

    bool renew() {
        auto told = with_flags(typed_, {}, false, known_);
        if (!told) return false;
        told_ = std::move(*told);
        told_list_ = options_of(told_);
        return true;
    }

    Design wanted_, told_;
    const KnownNames& known_;
    OptionList list_ = options_of(wanted_), told_list_;
    std::vector<TypedFlag> typed_;
};

bool is_plain(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           std::string_view("_./,:=+-").find(c) != std::string_view::npos;
}

/// For a shell.
std::string in_shell(std::string_view text) {
    if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return std::string(text);
    std::string inside;
    for (const char c : text) inside += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return "'" + inside + "'";
}

/// A name that begins with a minus sign is no flag.
std::string file_in_shell(std::string_view name) {
    return in_shell((name.starts_with('-') ? "./" : "") + std::string(name));
}

/// `made_of`: what the folder is named after. `in_a_row`: what has no place is not arranged by itself.
std::string line_of(const std::vector<std::string>& objects, std::string_view made_of, const Design& design,
                    const KnownNames& known, Language language, bool in_a_row = false) {
    std::string line = "snug make";
    for (const std::string& object : objects) line += " " + file_in_shell(object);
    // With "=", since a value may begin with a minus sign.
    for (const TypedFlag& typed : flags_for(design, known)) {
        line += " " + typed.flag;
        if (!typed.text.empty()) line += "=" + in_shell(typed.text);
    }
    if (in_a_row) line += " --no-arrange";
    if (language != Language::english) line += " --language=" + std::string(language_name(language));
    return line + " -o " + file_in_shell(std::string(made_of.substr(0, made_of.rfind('.'))) + "-foam");
}

}  // namespace

std::vector<TypedFlag> flags_for(const Design& design, const KnownNames& known) {
    return Telling(design, known).typed();
}

std::string command_line(std::string_view file, const Design& design, const KnownNames& known,
                         Language language) {
    return line_of({std::string(file)}, file, design, known, language);
}

std::string command_line(Project project, std::span<const std::string> files, const KnownNames& known,
                         Language language) {
    take_over_one_item(project);
    Design& design = project.design;
    if (design.items.size() == 1) return command_line(files.front(), design, known, language);
    const std::vector<std::string> items = typed_items(project, files);
    const bool in_a_row = wants_arrangement(design);
    design.items = {ItemOptions()};  // they have said all that is theirs
    return line_of(items, files.front(), design, known, language, in_a_row);
}

}  // namespace snug
