#include "snug/design/print_options.h"

#include "snug/base/text.h"
#include "snug/design/option_list.h"

namespace snug {

std::optional<OptionProblem> problem_of(const PrintOptions& o) {
    if (auto found = out_of_range(o)) return found;
    if (o.dowel_length_mm < o.dowel_diameter_mm)
        return OptionProblem{"dowel_length_mm",
                             say("dowel.shorter_than_wide", {{"length", number(o.dowel_length_mm, 4)},
                                                             {"least", number(o.dowel_diameter_mm)}})};
    return {};
}

}  // namespace snug
