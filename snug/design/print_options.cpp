#include "snug/design/print_options.h"

#include "snug/base/range.h"

namespace snug {

std::optional<std::string> problem_of(const PrintOptions& o) {
    const char* const sides[] = {"the bed's width", "the bed's depth", "the height above the bed"};
    for (int axis = 0; axis < 3; ++axis)
        if (!within(o.bed_mm[axis], 10, 2000)) return out_of_range(sides[axis], o.bed_mm[axis], 10, 2000);
    if (!within(o.dowel_diameter_mm, 1, 100))
        return out_of_range("the dowel's diameter", o.dowel_diameter_mm, 1, 100);
    if (!within(o.dowel_length_mm, o.dowel_diameter_mm, 1000))
        return out_of_range("the dowel's length", o.dowel_length_mm, o.dowel_diameter_mm, 1000);
    if (!within(o.joint_clearance_mm, 0, 5))
        return out_of_range("the clearance around a dowel", o.joint_clearance_mm, 0, 5);
    return {};
}

}  // namespace snug
