#include "snug/design/foam_material.h"

#include "snug/design/option_list.h"

namespace snug {

std::optional<OptionProblem> problem_of(const FoamMaterial& foam) {
    if (auto found = out_of_range(foam)) return found;
    if (!foam.curve.empty())
        if (auto found = problem_of(std::span<const StressPoint>(foam.curve)))
            return OptionProblem{"curve", say("curve.must_be", {{"what", *found}})};
    if (foam.thickness_mm && foam.thickness_mm->x > foam.thickness_mm->y)
        return OptionProblem{"thickness_mm", say("foam.thickness")};
    return {};
}

}  // namespace snug
