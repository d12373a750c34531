#include "snug/space/case_space.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/design/design.h"
#include "snug/space/available.h"

namespace snug {
namespace {

constexpr double kCaseRounding = 1e-6;  // mm: faces that coincide with the case's are inside
constexpr double kLeastRest = 0.01;     // mm: what is thinner is no strip

bool divided_freely(Division division, int axis) {
    return division == Division::all || (division == Division::across && axis > 0);
}

/// Where the lid begins, above the inside floor.
double lid_line(const CaseOptions& options) {
    return options.inside_mm->x - options.lid_mm.value_or(0);
}

CrossSection between(const CrossSection& low, const CrossSection& high, double share) {
    return {low.width + (high.width - low.width) * share, low.length + (high.length - low.length) * share};
}

/// Inside the case at a height above its floor, without the play.
CrossSection section_at(const CaseOptions& options, double height) {
    const Vec3d inside = *options.inside_mm;
    const CrossSection widest{inside.y, inside.z};
    const double line = lid_line(options), lid = inside.x - line;
    CrossSection section = widest;
    if (height < line)
        section = between(options.base_mm.value_or(widest), widest, std::max(0.0, height) / line);
    else if (lid > 0)
        section = between(widest, options.top_mm.value_or(widest), std::min(1.0, (height - line) / lid));
    return {section.width - 2 * options.play_mm, section.length - 2 * options.play_mm};
}

/// Whether the columns' cell, by its corner that is farthest from the case's middle, lies in the
/// cross-section where x is `x`.
bool holds(const CaseSpace& fitted, double x, double far_y, double far_z) {
    const CaseOptions& options = fitted.options;
    const CrossSection section = section_at(options, x - fitted.free.min.x + options.play_mm);
    const double half_width = section.width / 2, half_length = section.length / 2;
    if (far_y > half_width + kCaseRounding || far_z > half_length + kCaseRounding) return false;
    const double radius = std::max(0.0, options.corner_radius_mm - options.play_mm);
    const double y = far_y - (half_width - radius), z = far_z - (half_length - radius);
    const double most = radius + kCaseRounding;
    return y <= 0 || z <= 0 || y * y + z * z <= most * most;
}

double farthest(double low, double high, double middle) {
    return std::max(std::fabs(low - middle), std::fabs(high - middle));
}

/// The run of faces across x that hold a cell, as first..end of the blocks between them. The case is convex
/// and widest at its lid's line, so the run includes a face next to that line, or it is empty.
Run run_inside(const CaseSpace& fitted, double far_y, double far_z) {
    const DesignSpace& space = fitted.space;
    const auto face_holds = [&](int i) { return holds(fitted, space.face(0, i), far_y, far_z); };
    const double line = fitted.free.min.x - fitted.options.play_mm + lid_line(fitted.options);
    const double position = std::floor((line - space.face(0, 0)) / space.block_mm.x);
    const int below = static_cast<int>(std::clamp(position, 0.0, 1.0 * space.blocks.x));
    int inside = below;
    if (!face_holds(inside)) inside = std::min(below + 1, space.blocks.x);
    if (!face_holds(inside)) return {};
    const auto last_good = [&](int good, int bad) {
        while (std::abs(good - bad) > 1) {
            const int middle = (good + bad) / 2;
            (face_holds(middle) ? good : bad) = middle;
        }
        return good;
    };
    const int first = face_holds(0) ? 0 : last_good(inside, 0);
    const int end = face_holds(space.blocks.x) ? space.blocks.x : last_good(inside, space.blocks.x);
    return {static_cast<std::int16_t>(first), static_cast<std::int16_t>(end)};
}

/// Chooses where the rest along x lies, and the block boundary nearest to the lid's line.
void meet_lid(CaseSpace& fitted) {
    if (!fitted.options.lid_mm) return;
    const double line = lid_line(fitted.options);
    const double size = fitted.space.block_mm.x;
    const int blocks = fitted.space.blocks.x;
    double nearest = 0;
    for (const bool under : {true, false}) {
        const double begin = fitted.options.play_mm + (under ? fitted.rest_mm.x : 0);
        const int level =
            static_cast<int>(std::clamp(std::floor((line - begin) / size + 0.5), 0.0, 1.0 * blocks));
        const double off = begin + level * size - line;
        if (!under && std::fabs(off) > nearest - kCaseRounding) continue;
        nearest = std::fabs(off);
        fitted.rest_under = under;
        fitted.lid_level = level;
        fitted.lid_off_mm = off;
    }
}

}  // namespace

Result<CaseSpace> case_space(const CaseOptions& options, Vec3d block_mm) {
    CaseSpace fitted;
    fitted.options = options;
    const Vec3d free = *options.inside_mm - Vec3d{2, 2, 2} * options.play_mm;
    for (int axis = 0; axis < 3; ++axis) {
        const double length = free[axis];
        const bool freely = divided_freely(options.division, axis);
        double count = freely ? std::max(1.0, std::floor(length / block_mm[axis] + 0.5))
                              : std::floor((length + kCaseRounding) / block_mm[axis]);
        if (count < 1 || (freely && length < kLeastBlockSize))
            return fail(ErrorKind::does_not_fit,
                        say("case.too_small", {{"inside", dimensions({free.z, free.y, free.x})},
                                               {"block", dimensions({block_mm.z, block_mm.y, block_mm.x})}}));
        if (count > kMostBlocks) return fail(ErrorKind::usage, say("case.too_many_blocks"));
        fitted.space.blocks[axis] = static_cast<int>(count);
        fitted.space.block_mm[axis] = freely ? length / count : block_mm[axis];
        const double rest = freely ? 0 : length - count * block_mm[axis];
        fitted.rest_mm[axis] = rest < kLeastRest ? 0 : rest;
    }
    meet_lid(fitted);
    const Box3d blocks = fitted.space.box();
    fitted.free.min = {fitted.rest_under ? blocks.max.x - free.x : blocks.min.x, blocks.min.y, blocks.min.z};
    fitted.free.max = fitted.free.min + free;
    return fitted;
}

CaseSpace standing_on_floor(CaseSpace fitted) {
    const double up = fitted.space.box().min.x - fitted.free.min.x;
    fitted.free.min.x += up;
    fitted.free.max.x += up;
    fitted.rest_under = false;
    return fitted;
}

std::vector<Filler> fillers(const CaseSpace& fitted, int parting_level, bool open) {
    const Vec3d rest = fitted.rest_mm, free = fitted.free.size(), foam = fitted.space.size();
    std::vector<Filler> list;
    if (rest.x > 0)
        list.push_back({fitted.rest_under ? kFloor : kRoof, !fitted.rest_under, {rest.x, free.y, free.z}});
    const double lower = parting_level * fitted.space.block_mm.x;
    for (const auto& [height, lid] : {std::pair(lower, false), std::pair(foam.x - lower, true)}) {
        if (height <= 0) continue;
        if (rest.y > 0) list.push_back({kFront, lid, {height, rest.y, free.z}});
        if (rest.z > 0) list.push_back({kRight, lid, {height, foam.y, rest.z}});
    }
    if (open) std::erase_if(list, [](const Filler& filler) { return filler.lid; });
    return list;
}

bool has_shape(const CaseOptions& options) {
    return options.corner_radius_mm > options.play_mm || options.base_mm || options.top_mm;
}

Grid<Run> available_blocks(const CaseSpace& fitted) {
    const DesignSpace& space = fitted.space;
    if (!has_shape(fitted.options)) return all_blocks(space.blocks);
    const Vec3d middle = fitted.free.centre();
    Grid<Run> available(space.blocks.y, space.blocks.z);
    for (int j = 0; j < space.blocks.y; ++j) {
        const double far_y = farthest(space.face(1, j), space.face(1, j + 1), middle.y);
        for (int k = 0; k < space.blocks.z; ++k)
            available(j, k) =
                run_inside(fitted, far_y, farthest(space.face(2, k), space.face(2, k + 1), middle.z));
    }
    return available;
}

bool lies_inside(const CaseSpace& fitted, Vec3d low, Vec3d high) {
    const Vec3d middle = fitted.free.centre();
    if (low.x < fitted.free.min.x - kCaseRounding || high.x > fitted.free.max.x + kCaseRounding) return false;
    const double far_y = farthest(low.y, high.y, middle.y), far_z = farthest(low.z, high.z, middle.z);
    return holds(fitted, low.x, far_y, far_z) && holds(fitted, high.x, far_y, far_z);
}

}  // namespace snug
