#include "snug/design/clean_options.h"

#include <cmath>

#include "snug/base/text.h"

namespace snug {

std::optional<std::string> problem_of(const CleanOptions& options) {
    constexpr double kMost = 1e6;
    for (const int part : options.drop_parts)
        if (part < 1) return "parts are numbered from 1, there is no part " + std::to_string(part);
    if (!(options.drop_below_mm >= 0 && options.drop_below_mm <= kMost))
        return "parts are dropped below 0 to 1000000 mm, not " + number(options.drop_below_mm, 4);
    if (!options.cut_plane) return {};
    const auto& [x, y, z, distance] = *options.cut_plane;
    const double length = std::sqrt(x * x + y * y + z * z);
    if (!(length >= 1e-9 && length <= 1e9) || !(std::fabs(distance) <= 1e9))
        return "a cutting plane needs a direction x,y,z that is not 0, and a distance in mm";
    return {};
}

}  // namespace snug
