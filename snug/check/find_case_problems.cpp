#include "snug/check/find_case_problems.h"

#include <cmath>

#include "snug/base/text.h"
#include "snug/space/fitted_space.h"

namespace snug {
namespace {

constexpr double kLeastOff = 0.5;  // mm off the lid's line that are worth a note

/// Length, width, height.
std::string case_size(Vec3d inside) {
    return dimensions({inside.z, inside.y, inside.x});
}

}  // namespace

std::vector<Message> with_clearance(const Clearance& clearance_mm) {
    if (clearance_mm == Clearance()) return {};
    return {say("with_clearance")};
}

Vec3d least_inside(const CaseOptions& options, Vec3d block_mm, Vec3d object_size,
                   const Clearance& clearance_mm, const Walls& walls) {
    const Vec3d counts =
        fitted_blocks(grown({object_size * -0.5, object_size * 0.5}, clearance_mm), block_mm, walls);
    Vec3d inside;
    for (int axis = 0; axis < 3; ++axis) inside[axis] = counts[axis] * block_mm[axis] + 2 * options.play_mm;
    return inside;
}

Message too_small(const CaseSpace& fitted, Vec3d object_size, const Clearance& clearance_mm,
                  const Walls& walls) {
    constexpr const char* kLacking[3] = {"lacking.height", "lacking.width", "lacking.length"};
    const DesignSpace& space = fitted.space;
    const Vec3d foam = space.size();
    const Vec3d needed = grown({object_size * -0.5, object_size * 0.5}, clearance_mm).size();
    std::vector<Message> lacking;
    for (int axis = 0; axis < 3; ++axis)
        if (needed[axis] - 0.02 > foam[axis])
            lacking.push_back(say(kLacking[axis], {{"mm", number(needed[axis] - foam[axis], 1)}}));
    if (lacking.empty()) lacking.push_back(say("lacking.place"));
    const Vec3d least = least_inside(fitted.options, space.block_mm, object_size, clearance_mm, walls);
    return say("outside/case", {{"needed", case_size(needed)},
                                {"clearance", with_clearance(clearance_mm)},
                                {"foam", case_size(foam)},
                                {"lacking", lacking},
                                {"least", case_size(least)}});
}

Message too_small_for_items(const CaseSpace& fitted, const Box3d& room, std::vector<Message> clearance,
                            const Walls& walls) {
    const Vec3d size = room.size();
    const Vec3d least = least_inside(fitted.options, fitted.space.block_mm, size, {}, walls);
    return say("outside/items_in_case", {{"foam", case_size(fitted.space.size())},
                                         {"needed", case_size(size)},
                                         {"clearance", std::move(clearance)},
                                         {"least", case_size(least)},
                                         {"example", kPlacedItem}});
}

void find_case_problems(const CaseSpace& fitted, const FitReport& fit, int parting_level,
                        std::vector<Finding>& findings) {
    if (fit.outside_blocks > 0)
        findings.push_back({Severity::danger, say("leaves_case", {{"blocks", fit.outside_blocks}})});
    if (!fit.open && fitted.lid_level && parting_level == *fitted.lid_level &&
        std::fabs(fitted.lid_off_mm) > kLeastOff)
        findings.push_back(
            {Severity::note, say(fitted.lid_off_mm > 0 ? "off_lid_line/above" : "off_lid_line/below",
                                 {{"mm", number(std::fabs(fitted.lid_off_mm), 1)}})});
}

}  // namespace snug
