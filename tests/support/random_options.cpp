#include "tests/support/random_options.h"

#include <algorithm>
#include <cmath>

#include "snug/design/brick_parts.h"
#include "snug/design/option_list.h"

namespace snug::test {
namespace {

/// Puts a random value of the row's range where an option lies.
struct Drawing {
    Random& random;
    const OptionRow& row;

    void operator()(std::monostate) const {}
    void operator()(bool* value) const { *value = random.chance(0.5); }
    void operator()(double* value) const {
        const auto [least, most, above, or_zero] = row.range;
        const double high = row.range.any() ? 100 : std::min(most, std::max(least, 0.0) + 300);
        *value = random.between(std::max(least, -300.0),
                                random.chance(0.5) ? high : std::min(high, std::max(least, -300.0) + 5));
        if (random.chance(0.3)) *value = std::ceil(*value) <= high ? std::ceil(*value) : *value;
        if (or_zero && random.chance(0.3)) *value = 0;
    }
    void operator()(int* value) const {
        double drawn = 0;
        (*this)(&drawn);
        *value = static_cast<int>(std::floor(drawn));
    }
    void operator()(std::uint32_t* value) const {
        *value = static_cast<std::uint32_t>(random.integer(0, 2147483647));
    }
    void operator()(std::string* value) const { *value = word(); }
    void operator()(Vec2d* v) const { all({&v->x, &v->y}); }
    void operator()(CrossSection* v) const { all({&v->width, &v->length}); }
    template <class T>
    void operator()(Vec3<T>* v) const {
        all({&v->x, &v->y, &v->z});
    }
    void operator()(Clearance* v) const {
        Vec3d lower, upper;
        for (int axis = 0; axis < 3; ++axis) {
            lower[axis] = random.between(0, 5);
            upper[axis] = random.between(0, 5);
        }
        *v = random.chance(0.3) ? Clearance(lower.x) : Clearance(lower, random.chance(0.3) ? lower : upper);
    }
    template <std::size_t N>
    void operator()(std::array<double, N>* values) const {
        for (double& value : *values) (*this)(&value);
        if (random.chance(0.3)) values->fill((*values)[0]);
    }
    void operator()(std::vector<int>* values) const {
        list(*values, [&](int& value) { value = random.integer(1, 99); });
    }
    void operator()(std::vector<std::string>* values) const {
        list(*values, [&](std::string& value) { value = row.words.empty() ? size() : word(); });
    }
    void operator()(std::vector<BrickStock>* values) const {
        list(*values, [&](BrickStock& stock) { stock = {size(), random.integer(0, 999)}; });
        // As an object of JSON has them: each once, in order.
        const auto less = [](const BrickStock& a, const BrickStock& b) { return a.size < b.size; };
        const auto same = [](const BrickStock& a, const BrickStock& b) { return a.size == b.size; };
        std::sort(values->begin(), values->end(), less);
        values->erase(std::unique(values->begin(), values->end(), same), values->end());
    }
    void operator()(std::vector<StressPoint>* points) const {
        points->clear();
        StressPoint point;
        for (int i = random.integer(0, 3) * 2; i > 0; --i) {
            point = {point.strain + random.between(0.01, 0.15), point.kpa + random.between(0.1, 50)};
            points->push_back(point);
        }
    }
    void operator()(Zones* zones) const {
        list(*zones, [&](Zone& zone) {
            if (random.chance(0.4)) zone.part = random.integer(1, 9);
            for (int i = zone.part == 0 ? 1 : random.integer(0, 2); i > 0; --i)
                zone.balls.push_back({{random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)},
                                      random.between(0.1, 30)});
            zone.keep_off_mm = random.between(0.1, 30);
            zone.loose = random.chance(0.3);
            if (!zone.loose && random.chance(0.4)) zone.press_kpa = random.between(0.1, 9);
        });
    }
    void operator()(HandEdits* edits) const {
        list(*edits, [&](HandEdit& edit) {
            const int piece = random.integer(0, 2);
            edit.piece = piece == 0   ? "lower"
                         : piece == 1 ? "upper"
                                      : "middle-" + std::to_string(random.integer(1, 3));
            edit.j = random.integer(0, 9);
            edit.k = random.integer(0, 9);
            edit.blocks = random.chance(0.5) ? random.integer(1, 3) : -random.integer(1, 3);
            edit.under = piece == 2 && random.chance(0.5);
        });
    }
    /// Of one layer, since what is random elsewhere has no more.
    void operator()(PartingLevels* levels) const {
        levels->each.resize(1);
        (*this)(levels->each.data());
    }
    void operator()(const Choice& choice) const {
        const int last = static_cast<int>(choice.words.size()) - 1;
        choice.set(random.integer(choice.may_be_none ? -1 : 0, last));
    }
    template <class T>
    void operator()(std::optional<T>* value) const {
        value->reset();
        if (random.chance(0.7)) (*this)(&value->emplace());
    }

  private:
    template <class T>
    void all(std::initializer_list<T*> values) const {
        for (T* const value : values) (*this)(value);
    }
    template <class T, class Draw>
    void list(std::vector<T>& values, Draw draw) const {
        values.resize(static_cast<std::size_t>(random.integer(0, 3)));
        for (T& value : values) draw(value);
    }
    [[nodiscard]] std::string size() const {
        const BrickPart& part = brick_parts()[static_cast<std::size_t>(random.integer(0, 7))];
        return std::to_string(part.width) + "x" + std::to_string(part.length);
    }
    [[nodiscard]] std::string word() const {
        const auto any = [&](auto words) {
            return std::string(
                words[static_cast<std::size_t>(random.integer(0, static_cast<int>(words.size()) - 1))]);
        };
        if (!row.words.empty()) return any(row.words);
        if (row.flag == "--brick-colors") return std::string(any(std::array{"dark red", "tan", "orange"}));
        return any(
            std::array{"", "slit-10", "mill", "cube-10in", "EUR", "a'$(b) &", "\"ü\" -=x", "12x3x4", "none"});
    }
};

}  // namespace

Design random_options(Random& random) {
    Design design;
    if (random.chance(0.5)) design.fit.notches.emplace();
    if (random.chance(0.5)) design.fit.pads.emplace();
    if (random.chance(0.5)) design.fit.relief.emplace();
    if (random.chance(0.5)) design.fit.lift.emplace();
    if (random.chance(0.5)) design.protection.foam.emplace();
    const std::size_t count = options_of(design).options.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (!random.chance(0.4)) continue;
        Design changed = design;
        const OptionList list = options_of(changed);
        if (list.options[i].path == "items.0.object") continue;  // there is one alone
        std::visit(Drawing{random, list.options[i].row}, list.options[i].value);
        // What does not go together with what was drawn before is left as it was.
        if (auto possible = checked(changed)) design = *possible;
    }
    return design;
}

}  // namespace snug::test
