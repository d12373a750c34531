#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "snug/base/vec.h"
#include "snug/design/option.h"

namespace snug {

/// What a search makes small or large.
enum class Objective {
    cut,      ///< least cut volume: the paper's F
    gap,      ///< least gap between surface and foam along x, on average over the touched columns
    depth,    ///< least insertion depth: what is cut along x
    bearing,  ///< most bearing area: columns whose foam lies within 3 mm of the surface
    flat,     ///< lies flat and stable: low over its wide base
    shock,    ///< least that it meets in a drop on its worst side, for what it bears
};
constexpr std::size_t kObjectives = 6;
template <>
struct Names<Objective> {
    static constexpr std::string_view list[] = {"cut", "gap", "depth", "bearing", "flat", "shock"};
};

/// One for each objective; a type of its own, so that nothing else of as many numbers is taken for it.
struct Weights : std::array<double, kObjectives> {};

/// A direction along one of the object's own axes.
enum class Upright { plus_x, plus_y, plus_z, minus_x, minus_y, minus_z };
template <>
struct Names<Upright> {
    static constexpr std::string_view list[] = {"x", "y", "z", "-x", "-y", "-z"};
};
[[nodiscard]] Vec3d direction(Upright upright);

enum class CaseGoal { volume, billed_weight };
template <>
struct Names<CaseGoal> {
    static constexpr std::string_view list[] = {"volume", "billed-weight"};
};

/// Which rotations an arrangement may give an item, beside the one that it has.
enum class Turns {
    none,
    upright,  ///< quarter turns about the upright axis
    quarter,  ///< all quarter turns
    any,
};
template <>
struct Names<Turns> {
    static constexpr std::string_view list[] = {"none", "upright", "quarter", "any"};
};

constexpr int kMostLayers = 20;

/// How the best placement, the smallest case and the best arrangement are searched.
struct SearchOptions {
    Weights weight{{1}};             ///< of each objective, 0 to 1000; not all 0
    std::optional<Upright> upright;  ///< this axis of the object stays along +x
    CaseGoal case_goal = CaseGoal::volume;
    double billed_divisor = 5000;  ///< cm3 that are billed as a kilogram, 100 to 100,000
    std::uint32_t seed = 1;
    Turns turns = Turns::upright;  ///< of arranged items, and of one that is searched with shock weighed
    /// In how many layers they are arranged; 1: each in that of its own; none: in whichever are best.
    std::optional<int> layers = 1;
    friend bool operator==(const SearchOptions&, const SearchOptions&) = default;

    [[nodiscard]] bool weighs(Objective objective) const {
        return weight[static_cast<std::size_t>(objective)] > 0;
    }
};

/// --billed-weight
[[nodiscard]] SharedFlag<SearchOptions> billed_weight_flag();

template <class Visit>
void visit_options(Visit& visit, SearchOptions& search) {
    visit.option(
        search.weight,
        {.json = "weights",
         .flag = "--objective",
         .takes = "NAME[=WEIGHT],...",
         .range = {0, 1000},
         .step = 0.1,
         .label = {"the weight of an objective", "目的の重み"},
         .help = {"What --optimize weighs: cut, gap, depth, bearing, flat, shock",
                  "--optimize "
                  "が重視するもの：cut（切り取る量）、gap（表面のすきま）、depth（差"
                  "し込む深さ）、bearing（支える面）、flat（低く安定した向き）、shock（落下の衝撃）"},
         .usual = "cut"});
    visit.option(search.upright,
                 {.json = "upright",
                  .flag = "--upright",
                  .label = {"the axis that stays upward", "上に保つ軸"},
                  .help = {"Keep this axis of the object upward", "対象物のこの軸を上に保ちます"},
                  .scope = Scope::item});
    visit.option(search.case_goal,
                 {.json = "case",
                  .flag = "--billed-weight",
                  .label = {"what the smallest case is measured by", "最小のケースの基準"},
                  .help = {"What --fit-case makes small: the volume, or the weight that a carrier bills",
                           "--fit-case が小さくするもの：体積、または運送会社の請求重量"}});
    visit.flag(search, billed_weight_flag());
    visit.option(search.billed_divisor, {.json = "billed_divisor",
                                         .flag = "--billed-divisor",
                                         .takes = "CM3",
                                         .unit = "cm3",
                                         .range = {100, 100000},
                                         .step = 100,
                                         .label = {"the divisor of the billed weight", "請求重量の除数"},
                                         .help = {"With --billed-weight: cm3 that are billed as a kilogram",
                                                  "--billed-weight のとき、1 kg として請求される cm3"}});
    visit.option(search.seed, {.json = "seed",
                               .flag = "--seed",
                               .takes = "N",
                               .range = {0, 2147483647},
                               .step = 1,
                               .label = {"the seed", "乱数の種"},
                               .help = {"Another search; the same seed finds the same",
                                        "別の探索をします。同じ値なら同じ結果になります"}});
    visit.option(
        search.turns,
        {.json = "turns",
         .flag = "--turns",
         .label = {"how arranged items may be turned", "並べるときの回し方"},
         .help = {"With --arrange or --objective shock: how items may be turned from how they are given",
                  "--arrange または --objective shock "
                  "で、指定の向きからどのように回してよいか：none（回さない）、upright（縦軸まわり"
                  "の 90 度ごと）、quarter（すべての 90 度ごと）、any（自由）"}});
    visit.option(search.layers, {.json = "layers",
                                 .flag = "--layers",
                                 .takes = "N|auto",
                                 .range = {1, kMostLayers},
                                 .step = 1,
                                 .label = {"the number of layers", "段の数"},
                                 .help = {"With --arrange: over how many layers the items are spread",
                                          "--arrange で、いくつの段に分けて置くか"},
                                 .usual = {"1, or as the items have them", "1、または各々の段の指定どおり"},
                                 .none = "auto"});
}

/// What is out of range; none where all is well.
[[nodiscard]] std::optional<OptionProblem> problem_of(const SearchOptions& options);

}  // namespace snug
