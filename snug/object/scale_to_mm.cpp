#include "snug/object/scale_to_mm.h"

#include <algorithm>
#include <string>

#include "snug/base/text.h"
#include "snug/object/prepare.h"

namespace snug {
namespace {

constexpr double kLongestPlausible = 5000;  // mm

}  // namespace

double millimetres_per_unit(Vec3d size, const ObjectOptions& options, bool in_mm) {
    if (options.longest_mm) return *options.longest_mm / std::max({size.x, size.y, size.z});
    return millimetres(in_mm ? Unit::mm : options.units.value_or(Unit::mm)) * options.scale;
}

std::optional<Error> implausible_size(Vec3d size, const Design& design) {
    if (design.object.units || design.object.longest_mm) return {};
    const Vec3d mm = size * design.object.scale;
    const Vec3d block = design.space.block_mm;
    const bool tiny = mm.x < block.x && mm.y < block.y && mm.z < block.z;
    const bool huge = std::max({mm.x, mm.y, mm.z}) > kLongestPlausible;
    if (!tiny && !huge) return {};
    const auto read_as = [&](Unit unit) { return dimensions(mm * millimetres(unit), 1); };
    return Error{ErrorKind::input,
                 say("unit.implausible", {{"size", dimensions(mm, 3)},
                                          {"problem", say(tiny ? "unit.tiny" : "unit.huge")},
                                          {"mm", read_as(Unit::mm)},
                                          {"cm", read_as(Unit::cm)},
                                          {"m", read_as(Unit::m)},
                                          {"in", read_as(Unit::in)}})};
}

}  // namespace snug
