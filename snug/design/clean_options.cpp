#include "snug/design/clean_options.h"

#include <cmath>

#include "snug/design/option_list.h"

namespace snug {

std::optional<OptionProblem> problem_of(const CleanOptions& options) {
    if (auto found = out_of_range(options)) return found;
    if (!options.cut_plane) return {};
    const auto& [x, y, z, distance] = *options.cut_plane;
    const double length = std::sqrt(x * x + y * y + z * z);
    if (!(length >= 1e-9 && length <= 1e9) || !(std::fabs(distance) <= 1e9))
        return OptionProblem{"cut_plane", say("clean.no_direction")};
    return {};
}

}  // namespace snug
