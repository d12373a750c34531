#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/message.h"
#include "snug/base/names.h"
#include "snug/base/result.h"

// The table of options. Beside each struct of options stands a function
//
//     template <class Visit> void visit_options(Visit& visit, FitOptions& fit)
//
// that names every member with a row. Project files, ranges, the command line and its help, the page's fields
// and docs/options.md are made from it (option_list.h and what uses it).

namespace snug {

/// A text in both languages, which stands in the option's row instead of in the catalogue. From one literal:
/// the same in both. Literals only, since nothing is copied.
struct Words {
    constexpr Words() = default;
    constexpr Words(const char* same) : english(same), japanese(same) {}
    constexpr Words(const char* english_, const char* japanese_) : english(english_), japanese(japanese_) {}
    [[nodiscard]] constexpr bool empty() const { return english.empty(); }

    std::string_view english, japanese;
};

[[nodiscard]] inline Message said(const Words& words) {
    return say("in_both", {{"english", words.english}, {"japanese", words.japanese}});
}

/// Each as it is, for a place that lists them.
template <class Texts>
[[nodiscard]] std::vector<Message> each_as_it_is(const Texts& texts) {
    std::vector<Message> messages;
    for (const auto& shown : texts) messages.push_back(as_it_is(std::string_view(shown)));
    return messages;
}

/// Whose choice an option is.
enum class Scope { design, object, item };
template <>
struct Names<Scope> {
    static constexpr std::string_view list[] = {"design", "object", "item"};
};

/// Where a number, or each of several, may lie. Bounds are included unless `above` says otherwise.
struct Range {
    double least = 0, most = 0;
    bool above = false;    ///< the least itself is not allowed
    bool or_zero = false;  ///< 0 is allowed besides; the help says what it means
    [[nodiscard]] constexpr bool any() const { return least == 0 && most == 0; }
    [[nodiscard]] constexpr bool has(double value) const {
        return (or_zero && value == 0) || ((above ? value > least : value >= least) && value <= most);
    }
};

/// Of what weighs something: masses, densities.
constexpr Range kAbove0{.least = 0, .most = 1e6, .above = true};

/// One option: everything that is known of it beside its type and its default, which its struct has.
struct OptionRow {
    std::string_view json = {};  ///< its name in a project file, within its struct's object
    std::string_view flag = {};  ///< "--least-rib"; several options may share one; empty: --set alone
    /// What stands behind the flag in the help: "MM". Empty: the words of a choice, else nothing, it is on.
    std::string_view takes = {};
    Words unit = {};  ///< "mm", "kg/m3"
    Range range = {};
    double step = 0;   ///< of the studio's field; 0: any
    double often = 0;  ///< what few go above, the end of the studio's slider; 0: the range's
    Words label = {};  ///< "the least rib", as sentences have it
    Words help = {};   ///< a sentence without its full stop and without the default
    Words usual = {};  ///< what --help says in brackets; empty: the default
    /// The word for no value on the command line ("none" where it is empty), and of numbers in project files
    /// (null where it is empty).
    std::string_view none = {};
    char separator = 'x';                          ///< between several numbers on the command line
    std::span<const std::string_view> words = {};  ///< all that a text may be; empty: any
    Scope scope = Scope::design;
    /// Its name among the choices that an object carries on the command line ("lens.stl:rotate=0x90x0").
    std::string_view word = {};
};

/// A struct of options within another.
struct GroupRow {
    std::string_view json = {};
    Words title = {};            ///< a heading: "Notches"
    std::string_view flag = {};  ///< that makes an optional group exist
};

/// A flag that says several options at once. Their rows name it.
template <class Options>
struct SharedFlag {
    std::string_view flag, takes;
    Words help;
    /// Puts what was typed into the options. Errors are of kind `usage` and name the flag.
    Result<void> (*take)(std::string_view text, Options& options);
    /// What to type for these options; none where the flag cannot say them.
    std::optional<std::string> (*say)(const Options& options);
    Words usual = {};
};

/// What is wrong with a struct of options. Ranges stand in the rows, and option_list.h has out_of_range() for
/// them; a struct with more to say has a problem_of() beside it, which what holds the struct asks as well.
struct OptionProblem {
    std::string path;  ///< of the field: "fit.least_rib_mm"
    Message message;   ///< what is out of range and what would do
    [[nodiscard]] OptionProblem within(std::string_view group) const {
        return {std::string(group) + (path.empty() ? "" : ".") + path, message};
    }
};

}  // namespace snug
