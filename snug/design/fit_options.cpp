#include "snug/design/fit_options.h"

#include <initializer_list>

#include "snug/base/text.h"

namespace snug {
namespace {

constexpr double kLongest = 10000;  // mm

}  // namespace

std::optional<std::string> problem_of(const FitOptions& options) {
    const auto sized = [](double mm) { return mm > 0 && mm <= kLongest; };
    if (options.least_rib_mm != 0 && !sized(options.least_rib_mm))
        return "the least rib must be 0 to 10000 mm, not " + number(options.least_rib_mm, 4);
    if (options.creep_kpa && !(*options.creep_kpa > 0 && *options.creep_kpa <= 1e6))
        return "the pressure that the foam bears for long must be above 0 kPa, not " +
               number(*options.creep_kpa, 4);
    if (!options.notches) return {};
    const NotchOptions& notches = *options.notches;
    for (const double mm : {notches.width_mm, notches.depth_mm, notches.room_mm})
        if (!sized(mm))
            return "a notch's width, depth and room must be above 0 and at most 10000 mm, not " +
                   number(mm, 4);
    if (notches.axis && *notches.axis != 1 && *notches.axis != 2)
        return "notches lie opposite each other along y or z";
    for (const auto& at : {notches.first_mm, notches.second_mm})
        if (at && !(*at >= -1e6 && *at <= 1e6)) return "a notch's place must be a number of mm in the space";
    return {};
}

}  // namespace snug
