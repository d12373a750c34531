#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "snug/design/design.h"
#include "snug/design/option.h"

// The table of options, bound to a design: a list that JSON, ranges, flags, documents go through.

namespace snug {

/// A value that is one of a few words, or none.
struct Choice {
    std::span<const std::string_view> words;
    bool may_be_none = false;
    std::function<int()> get;  ///< place in `words`; -1: none
    std::function<void(int)> set;
};

using Plane = std::array<double, 4>;

/// Where the value lies, by its type. monostate: a group that is absent.
using OptionValue =
    std::variant<std::monostate, bool*, int*, std::uint32_t*, double*, std::string*, Vec2d*, Vec3d*,
                 Clearance*, Weights*, std::vector<int>*, std::vector<std::string>*, std::vector<BrickStock>*,
                 std::vector<StressPoint>*, Zones*, HandEdits*, std::optional<Vec2d>*, std::optional<int>*,
                 std::optional<PartingLevels>*, std::optional<double>*, std::optional<Vec3d>*,
                 std::optional<Vec3i>*, std::optional<Walls>*, std::optional<Clearance>*,
                 std::optional<CrossSection>*, std::optional<Plane>*, Choice>;

struct Option {
    std::string path;  ///< "fit.least_rib_mm"
    OptionRow row;
    OptionValue value;
};

struct OptionGroup {
    std::string path;
    GroupRow row;
    bool present = true;
    bool optional = false;
    bool list = false;  ///< of structs: "items", of which "items.0" is the first
};

/// A flag of several options, bound to them.
struct BoundFlag {
    std::string_view flag, takes;
    Words help, usual;
    std::size_t at = 0;  ///< before which option of the list it was named
    std::function<Result<void>(std::string_view)> take;
    std::function<std::optional<std::string>()> say;
};

/// What visit_options() says, as lists in the table's order. Valid while the design it was made of is.
class OptionList {
  public:
    /// Whether an optional group is to exist: none: as it is.
    using Presence = std::function<std::optional<bool>(const std::string& path)>;
    /// How many structs a list is to have; none: as it is.
    using Length = std::function<std::optional<std::size_t>(const std::string& path)>;
    explicit OptionList(Presence presence = {}, Length length = {})
        : presence_(std::move(presence)), length_(std::move(length)) {}

    std::vector<Option> options;
    std::vector<OptionGroup> groups;
    std::vector<BoundFlag> flags;

    template <class Value>
    void option(Value& value, const OptionRow& row) {
        options.push_back({path(row.json), row, bound(value)});
    }

    template <class Options>
    void group(Options& inner, const GroupRow& row) {
        const std::string outer = std::exchange(prefix_, path(row.json));
        groups.push_back({prefix_, row});
        visit_options(*this, inner);
        prefix_ = outer;
    }

    template <class Options>
    void group(std::optional<Options>& inner, const GroupRow& row) {
        const std::string at = path(row.json);
        const bool wanted = (presence_ ? presence_(at) : std::nullopt).value_or(inner.has_value());
        if (wanted) {
            if (!inner) inner.emplace();
            const std::size_t here = groups.size();
            group(*inner, row);
            groups[here].optional = true;
            return;
        }
        inner.reset();
        groups.push_back({at, row, false, true});
        options.push_back({at, {.json = row.json, .flag = row.flag}, std::monostate{}});
    }

    /// A list of structs.
    template <class Options>
    void group(std::vector<Options>& inner, const GroupRow& row) {
        const std::string at = path(row.json);
        groups.push_back({at, row});
        groups.back().list = true;
        if (length_) inner.resize(length_(at).value_or(inner.size()));
        const std::string outer = std::exchange(prefix_, at);
        for (std::size_t i = 0; i < inner.size(); ++i) {
            const std::string number = std::to_string(i);
            group(inner[i], {.json = number, .title = row.title});
        }
        prefix_ = outer;
    }

    template <class Options>
    void flag(Options& options_of_it, const SharedFlag<Options>& row) {
        Options* const at = &options_of_it;
        flags.push_back({row.flag, row.takes, row.help, row.usual, options.size(),
                         [at, take = row.take](std::string_view text) { return take(text, *at); },
                         [at, say = row.say] { return say(*at); }});
    }

    [[nodiscard]] const Option* find(std::string_view path) const;
    [[nodiscard]] const OptionGroup* find_group(std::string_view path) const;
    /// The flag of several options; none where it is of one.
    [[nodiscard]] const BoundFlag* find_flag(std::string_view flag) const;
    /// The first option that the flag says.
    [[nodiscard]] const Option* find_by_flag(std::string_view flag) const;

  private:
    [[nodiscard]] std::string path(std::string_view name) const {
        return prefix_.empty() ? std::string(name) : prefix_ + "." + std::string(name);
    }

    template <class Value>
    static OptionValue bound(Value& value) {
        if constexpr (std::is_enum_v<Value>) {
            constexpr int skipped = Names<Value>::list[0].empty() ? 1 : 0;
            return Choice{names_of<Value>().subspan(skipped), skipped == 1,
                          [&value] { return static_cast<int>(value) - skipped; },
                          [&value](int at) { value = static_cast<Value>(at + skipped); }};
        } else {
            return &value;
        }
    }

    template <class Value>
    static OptionValue bound(std::optional<Value>& value) {
        if constexpr (std::is_enum_v<Value>) {
            return Choice{names_of<Value>(), true, [&value] { return value ? static_cast<int>(*value) : -1; },
                          [&value](int at) {
                              value.reset();
                              if (at >= 0) value = static_cast<Value>(at);
                          }};
        } else {
            return &value;
        }
    }

    Presence presence_;
    Length length_;
    std::string prefix_;
};

/// Every option of a design. `presence` and `length` as OptionList takes them.
[[nodiscard]] OptionList options_of(Design& design, OptionList::Presence presence = {},
                                    OptionList::Length length = {});

/// Every option that there can be, optional groups included.
[[nodiscard]] OptionList all_options(Design& design);

/// The first option of the list that is out of its row's range; none where all is well.
[[nodiscard]] std::optional<OptionProblem> out_of_range(const OptionList& list);

/// The same for one struct.
template <class Options>
[[nodiscard]] std::optional<OptionProblem> out_of_range(const Options& options) {
    Options copy = options;
    OptionList list;
    visit_options(list, copy);
    return out_of_range(list);
}

}  // namespace snug
