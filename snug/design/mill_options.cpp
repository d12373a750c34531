#include "snug/design/mill_options.h"

#include "snug/design/option_list.h"

namespace snug {

double wanted_step_down_mm(const MillOptions& options) {
    return options.step_down_mm.value_or(options.cutter_mm / 2);
}

std::optional<OptionProblem> problem_of(const MillOptions& options) {
    return out_of_range(options);
}

}  // namespace snug
