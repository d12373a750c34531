#include "snug/design/search_options.h"

#include <algorithm>

#include "snug/design/option_list.h"

namespace snug {

Vec3d direction(Upright upright) {
    const int index = static_cast<int>(upright);
    Vec3d result;
    result[index % 3] = index < 3 ? 1 : -1;
    return result;
}

SharedFlag<SearchOptions> billed_weight_flag() {
    return {.flag = "--billed-weight",
            .takes = "",
            .help = {"With --fit-case: the least billed weight, not volume",
                     "--fit-case で、体積ではなく請求重量を最小にします"},
            .take =
                [](std::string_view, SearchOptions& search) {
                    search.case_goal = CaseGoal::billed_weight;
                    return Result<void>();
                },
            .say =
                [](const SearchOptions& search) {
                    return search.case_goal == CaseGoal::billed_weight ? std::optional<std::string>("")
                                                                       : std::nullopt;
                }};
}

std::optional<OptionProblem> problem_of(const SearchOptions& search) {
    if (auto found = out_of_range(search)) return found;
    if (*std::max_element(search.weight.begin(), search.weight.end()) <= 0)
        return OptionProblem{"weights", say("search.no_weight")};
    return {};
}

}  // namespace snug
