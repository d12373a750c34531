#include "snug/design/print_options.h"

#include "snug/base/range.h"
#include "snug/design/option_list.h"

namespace snug {

std::optional<OptionProblem> problem_of(const PrintOptions& o) {
    if (auto found = out_of_range(o)) return found;
    if (o.dowel_length_mm < o.dowel_diameter_mm)
        return OptionProblem{"dowel_length_mm", out_of_range("the dowel's length", o.dowel_length_mm,
                                                             o.dowel_diameter_mm, 1000)};
    return {};
}

}  // namespace snug
