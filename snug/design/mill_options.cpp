#include "snug/design/mill_options.h"

#include "snug/base/range.h"

namespace snug {

std::string_view mill_origin_name(MillOrigin origin) {
    return origin == MillOrigin::centre ? "centre" : "corner";
}

std::optional<MillOrigin> mill_origin_from_name(std::string_view name) {
    for (const MillOrigin origin : {MillOrigin::corner, MillOrigin::centre})
        if (mill_origin_name(origin) == name) return origin;
    return {};
}

std::optional<std::string> problem_of(const MillOptions& o) {
    if (!within(o.cutter_mm, 0.5, 100)) return out_of_range("the cutter's diameter", o.cutter_mm, 0.5, 100);
    if (!within(o.flute_mm, 1, 1000)) return out_of_range("the flute's length", o.flute_mm, 1, 1000);
    if (o.step_down_mm && !within(*o.step_down_mm, 0.05, 1000))
        return out_of_range("the depth of a pass", *o.step_down_mm, 0.05, 1000);
    if (!within(o.stepover, 0.05, 0.9))
        return out_of_range("the stepover (a share of the cutter's diameter)", o.stepover, 0.05, 0.9, "");
    if (!within(o.feed_mm_min, 1, 50000))
        return out_of_range("the feed", o.feed_mm_min, 1, 50000, " mm a minute");
    if (!within(o.plunge_mm_min, 1, 50000))
        return out_of_range("the plunge feed", o.plunge_mm_min, 1, 50000, " mm a minute");
    if (!within(o.spindle_rpm, 1, 100000))
        return out_of_range("the spindle's speed", o.spindle_rpm, 1, 100000, " turns a minute");
    if (!within(o.safe_mm, 0.5, 200))
        return out_of_range("the safe height above the stock", o.safe_mm, 0.5, 200);
    if (o.pin_mm != 0 && !within(o.pin_mm, 1, 50))
        return out_of_range("the registration pins' diameter (0: none)", o.pin_mm, 1, 50);
    return {};
}

}  // namespace snug
