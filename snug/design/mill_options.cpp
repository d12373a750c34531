#include "snug/design/mill_options.h"

#include "snug/design/option_list.h"

namespace snug {

std::optional<OptionProblem> problem_of(const MillOptions& options) {
    return out_of_range(options);
}

}  // namespace snug
