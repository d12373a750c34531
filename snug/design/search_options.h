#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "snug/base/vec.h"

namespace snug {

/// What a search makes small or large.
enum class Objective {
    cut,      ///< least cut volume: the paper's F
    gap,      ///< least gap between surface and foam along x, on average over the touched columns
    depth,    ///< least insertion depth: what is cut along x
    bearing,  ///< most bearing area: columns whose foam lies within 3 mm of the surface
    flat,     ///< lies flat and stable: low over its wide base
};
constexpr std::size_t kObjectives = 5;
[[nodiscard]] std::string_view objective_name(Objective objective);
[[nodiscard]] std::optional<Objective> objective_from_name(std::string_view name);

/// A direction along one of the object's own axes.
enum class Upright { plus_x, plus_y, plus_z, minus_x, minus_y, minus_z };
[[nodiscard]] std::string_view upright_name(Upright upright);  ///< x, y, z, -x, -y, -z
[[nodiscard]] std::optional<Upright> upright_from_name(std::string_view name);
[[nodiscard]] Vec3d direction(Upright upright);

enum class CaseGoal { volume, billed_weight };
[[nodiscard]] std::string_view case_goal_name(CaseGoal goal);
[[nodiscard]] std::optional<CaseGoal> case_goal_from_name(std::string_view name);

/// How the best placement and the smallest case are searched.
struct SearchOptions {
    std::array<double, kObjectives> weight{1, 0, 0, 0, 0};  ///< of each objective, 0 to 1000; not all 0
    std::optional<Upright> upright;                         ///< this axis of the object stays along +x
    CaseGoal case_goal = CaseGoal::volume;
    double billed_divisor = 5000;  ///< cm3 that are billed as a kilogram, 100 to 100,000
    std::uint32_t seed = 1;
    friend bool operator==(const SearchOptions&, const SearchOptions&) = default;
};

}  // namespace snug
