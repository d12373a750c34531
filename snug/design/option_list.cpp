#include "snug/design/option_list.h"

#include <algorithm>

#include "snug/base/text.h"

namespace snug {
namespace {

using Problem = std::optional<Message>;

/// "12.5 mm"
Message with_unit(double value, const OptionRow& row) {
    const std::string shown = number(value, 9);
    return row.unit.empty() ? as_it_is(shown)
                            : say("option.with_unit", {{"value", shown}, {"unit", said(row.unit)}});
}

Message bounds(const OptionRow& row) {
    const Range& range = row.range;
    return say(range.above     ? "option.above"
               : range.or_zero ? "option.zero_or"
                               : "option.from",
               {{"least", number(range.least, 9)}, {"most", with_unit(range.most, row)}});
}

/// Says that a number is out of the row's range.
struct Judging {
    const OptionRow& row;

    Problem operator()(std::monostate) const { return {}; }
    Problem operator()(const bool*) const { return {}; }
    Problem operator()(const double* value) const {
        if (row.range.any() || row.range.has(*value)) return {};
        return say("option.out_of_range",
                   {{"label", said(row.label)}, {"value", with_unit(*value, row)}, {"bounds", bounds(row)}});
    }
    Problem operator()(const int* value) const { return of(*value); }
    Problem operator()(const std::uint32_t* value) const { return of(*value); }
    Problem operator()(const std::string* value) const {
        if (row.words.empty() || std::find(row.words.begin(), row.words.end(), *value) != row.words.end())
            return {};
        return say(
            "option.not_a_word",
            {{"label", said(row.label)}, {"words", each_as_it_is(row.words)}, {"found", quoted(*value)}});
    }
    Problem operator()(const Vec2d* v) const { return all({v->x, v->y}); }
    Problem operator()(const CrossSection* v) const { return all({v->width, v->length}); }
    Problem operator()(const Vec3d* v) const { return all({v->x, v->y, v->z}); }
    Problem operator()(const Vec3i* v) const { return (*this)(vec_cast<double>(*v)); }
    Problem operator()(const Vec3d& v) const { return (*this)(&v); }
    Problem operator()(const PartingLevels* levels) const { return first_of(levels->each); }
    Problem operator()(const Clearance* v) const {
        const Problem lower = (*this)(&v->lower);
        return lower ? lower : (*this)(&v->upper);
    }
    template <std::size_t N>
    Problem operator()(const std::array<double, N>* values) const {
        return first_of(*values);
    }
    template <class T>
    Problem operator()(const std::vector<T>* values) const {
        return first_of(*values);
    }
    Problem operator()(const StressPoint* point) const { return all({point->strain, point->kpa}); }
    Problem operator()(const Zone*) const { return {}; }      // has rules of its own
    Problem operator()(const HandEdit*) const { return {}; }  // the same
    Problem operator()(const BrickStock* stock) const { return of(stock->pieces); }
    Problem operator()(const Choice&) const { return {}; }
    template <class T>
    Problem operator()(const std::optional<T>* value) const {
        return *value ? (*this)(&**value) : Problem();
    }

  private:
    [[nodiscard]] Problem of(double value) const { return (*this)(&value); }
    [[nodiscard]] Problem all(std::initializer_list<double> values) const { return first_of(values); }
    template <class List>
    Problem first_of(const List& list) const {
        for (const auto& each : list)
            if (auto problem = (*this)(&each)) return problem;
        return {};
    }
};

}  // namespace

const Option* OptionList::find(std::string_view path) const {
    const auto found = std::find_if(options.begin(), options.end(),
                                    [&](const Option& option) { return option.path == path; });
    return found == options.end() ? nullptr : &*found;
}

const OptionGroup* OptionList::find_group(std::string_view path) const {
    const auto found = std::find_if(groups.begin(), groups.end(),
                                    [&](const OptionGroup& group) { return group.path == path; });
    return found == groups.end() ? nullptr : &*found;
}

const BoundFlag* OptionList::find_flag(std::string_view flag) const {
    const auto found =
        std::find_if(flags.begin(), flags.end(), [&](const BoundFlag& each) { return each.flag == flag; });
    return found == flags.end() ? nullptr : &*found;
}

const Option* OptionList::find_by_flag(std::string_view flag) const {
    const auto found = std::find_if(options.begin(), options.end(),
                                    [&](const Option& option) { return option.row.flag == flag; });
    return found == options.end() ? nullptr : &*found;
}

OptionList options_of(Design& design, OptionList::Presence presence, OptionList::Length length) {
    OptionList list(std::move(presence), std::move(length));
    visit_options(list, design);
    return list;
}

OptionList all_options(Design& design) {
    return options_of(design, [](const std::string&) { return true; });
}

std::optional<OptionProblem> out_of_range(const OptionList& list) {
    for (const Option& option : list.options)
        if (auto problem = std::visit(Judging{option.row}, option.value))
            return OptionProblem{option.path, *problem};
    return {};
}

}  // namespace snug
