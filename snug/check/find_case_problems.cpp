#include "snug/check/find_case_problems.h"

#include <cmath>

#include "snug/base/text.h"
#include "snug/space/fitted_space.h"

namespace snug {
namespace {

constexpr double kLeastOff = 0.5;  // mm off the lid's line that are worth a note

std::string case_size(Vec3d inside) {
    return dimensions({inside.z, inside.y, inside.x}) + " mm (length, width, height)";
}

}  // namespace

Vec3d least_inside(const CaseOptions& options, Vec3d block_mm, Vec3d object_size,
                   const Clearance& clearance_mm, const Walls& walls) {
    const Vec3d counts =
        fitted_blocks(grown({object_size * -0.5, object_size * 0.5}, clearance_mm), block_mm, walls);
    Vec3d inside;
    for (int axis = 0; axis < 3; ++axis) inside[axis] = counts[axis] * block_mm[axis] + 2 * options.play_mm;
    return inside;
}

std::string too_small(const CaseSpace& fitted, Vec3d object_size, const Clearance& clearance_mm,
                      const Walls& walls) {
    constexpr const char* kAxes[3] = {"height", "width", "length"};
    const DesignSpace& space = fitted.space;
    const Vec3d foam = space.size();
    const Vec3d needed = grown({object_size * -0.5, object_size * 0.5}, clearance_mm).size();
    std::string lacking;
    for (int axis = 0; axis < 3; ++axis)
        if (needed[axis] - 0.02 > foam[axis])
            lacking += (lacking.empty() ? "" : ", ") + number(needed[axis] - foam[axis], 1) + " mm of " +
                       kAxes[axis];
    if (lacking.empty()) lacking = "nothing but the place: it is moved out of the middle";
    return "the object needs " + case_size(needed) +
           (clearance_mm != Clearance() ? " with its clearance" : "") + " and leaves the foam of its case, " +
           case_size(foam) + ". Lacking: " + lacking + ". A case would do from " +
           case_size(least_inside(fitted.options, space.block_mm, object_size, clearance_mm, walls)) +
           " inside; `snug cases --for` lists those that fit, in every way to lay the object";
}

void find_case_problems(const CaseSpace& fitted, const FitReport& fit, int parting_level,
                        std::vector<Finding>& findings) {
    if (fit.outside_blocks > 0)
        findings.push_back(
            {Severity::danger,
             "leaves_case",
             "the object reaches into a rounded corner or leaning wall of the case: " +
                 counted(static_cast<unsigned long long>(fit.outside_blocks), "block", "blocks") +
                 " that it needs would lie outside; move or turn it, or take a larger case",
             {}});
    if (fitted.lid_level && parting_level == *fitted.lid_level && std::fabs(fitted.lid_off_mm) > kLeastOff)
        findings.push_back({Severity::note,
                            "off_lid_line",
                            "the foams part " + number(std::fabs(fitted.lid_off_mm), 1) + " mm " +
                                (fitted.lid_off_mm > 0 ? "above" : "below") +
                                " the lid's line, at the nearest step of the blocks",
                            {}});
}

}  // namespace snug
