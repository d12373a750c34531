#include "snug/design/mould_options.h"

#include "snug/design/option_list.h"

namespace snug {

std::optional<OptionProblem> problem_of(const MouldOptions& options) {
    return out_of_range(options);
}

}  // namespace snug
