#include "snug/design/search_options.h"

namespace snug {
namespace {

constexpr std::array<std::string_view, kObjectives> kObjectiveNames{"cut", "gap", "depth", "bearing", "flat"};
constexpr std::array<std::string_view, 6> kUprightNames{"x", "y", "z", "-x", "-y", "-z"};
constexpr std::array<std::string_view, 2> kCaseGoalNames{"volume", "billed-weight"};

template <class Choice, std::size_t count>
std::optional<Choice> choice(const std::array<std::string_view, count>& names, std::string_view name) {
    for (std::size_t i = 0; i < count; ++i)
        if (names[i] == name) return static_cast<Choice>(i);
    return {};
}

}  // namespace

std::string_view objective_name(Objective objective) {
    return kObjectiveNames[static_cast<std::size_t>(objective)];
}
std::optional<Objective> objective_from_name(std::string_view name) {
    return choice<Objective>(kObjectiveNames, name);
}

std::string_view upright_name(Upright upright) {
    return kUprightNames[static_cast<std::size_t>(upright)];
}
std::optional<Upright> upright_from_name(std::string_view name) {
    return choice<Upright>(kUprightNames, name);
}
Vec3d direction(Upright upright) {
    const int index = static_cast<int>(upright);
    Vec3d result;
    result[index % 3] = index < 3 ? 1 : -1;
    return result;
}

std::string_view case_goal_name(CaseGoal goal) {
    return kCaseGoalNames[static_cast<std::size_t>(goal)];
}
std::optional<CaseGoal> case_goal_from_name(std::string_view name) {
    return choice<CaseGoal>(kCaseGoalNames, name);
}

}  // namespace snug
