#include "snug/design/design.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "snug/base/text.h"

namespace snug {
namespace {

constexpr std::array<Unit, 4> kUnits{Unit::mm, Unit::cm, Unit::m, Unit::in};
constexpr std::array<std::string_view, 2> kFormats{"stl", "ply"};

using Problem = std::optional<std::string>;

bool within(double value, double least, double most) {
    return value >= least && value <= most;
}

bool within(Vec3d v, double least, double most) {
    return within(v.x, least, most) && within(v.y, least, most) && within(v.z, least, most);
}

Problem problem(const ObjectOptions& object) {
    if (!within(object.scale, 1e-9, 1e9))
        return "the scale must be a number above 0 (1e-9 to 1e9), not " + number(object.scale, 9);
    if (object.point_radius_mm != 0 && !within(object.point_radius_mm, 1e-6, kGreatestLength))
        return "the radius of a point must be 0 (from the spacing) to 1000000 mm, not " +
               number(object.point_radius_mm, 4);
    if (const auto wrong = problem_of(object.clean)) return wrong;
    if (object.longest_mm && !within(*object.longest_mm, 1e-3, kGreatestLength))
        return "the longest side must be 0.001 to 1000000 mm, not " + number(*object.longest_mm, 4);
    return {};
}

Problem problem(const SpaceOptions& space) {
    if (space.blocks) {
        const Vec3i n = *space.blocks;
        if (std::min({n.x, n.y, n.z}) < 1 || std::max({n.x, n.y, n.z}) > kMostBlocks)
            return "block counts run from 1 to 4096 on each axis, not " + dimensions(vec_cast<double>(n), 0);
    }
    if (!within(space.block_mm, kLeastBlockSize, kGreatestBlockSize))
        return "block sizes run from 0.1 to 10000 mm on each axis, not " + dimensions(space.block_mm, 4);
    for (const double wall : space.wall_mm.value_or(Walls{}))
        if (!within(wall, 0, kGreatestLength)) return "the wall must be 0 mm or more, not " + number(wall, 4);
    return {};
}

Problem problem(const PlacementOptions& placement) {
    if (!within(placement.rotation_deg, -1e6, 1e6)) return "each angle must be a number of degrees";
    if (!within(placement.offset_mm, -kGreatestLength, kGreatestLength))
        return "each offset must be a number of mm within the space";
    return {};
}

Problem problem(const CutOptions& cut, Vec3d block) {
    const double least = kLeastClearanceShare * std::min({block.x, block.y, block.z});
    if (!within(cut.liner_mm, 0, kGreatestLength))
        return "the liner must be 0 mm or more, not " + number(cut.liner_mm, 4);
    const Clearance whole = cut.whole_clearance_mm();
    if (whole.least() >= least && within(whole.lower, least, kGreatestLength) &&
        within(whole.upper, least, kGreatestLength))
        return {};
    if (whole.least() >= least) return "the clearance must be at most " + number(kGreatestLength) + " mm";
    return "the clearance must be " + number(least, 4) +
           " mm or more for these blocks (-0.4 of the smallest side), not " + number(whole.least(), 4);
}

Problem problem(const PartingOptions& parting, const SpaceOptions& space, bool fitted_to_case) {
    const int most = space.blocks && !fitted_to_case ? space.blocks->x : kMostBlocks;
    if (!parting.level || (*parting.level >= 0 && *parting.level <= most)) return {};
    return "the parting level must be auto or 0 to " + std::to_string(most) + " blocks, not " +
           std::to_string(*parting.level);
}

Problem problem(const OutputOptions& output) {
    if (output.formats.empty()) return "name at least one format: stl, ply";
    for (const std::string& format : output.formats)
        if (std::find(kFormats.begin(), kFormats.end(), format) == kFormats.end())
            return "unknown format " + quoted(format) + ": foams are written as stl, ply";
    return {};
}

Problem problem(const SearchOptions& search) {
    double sum = 0;
    for (const double weight : search.weight) {
        if (!within(weight, 0, 1000)) return "weights of objectives run from 0 to 1000";
        sum += weight;
    }
    if (sum <= 0) return "give at least one objective a weight above 0";
    if (!within(search.billed_divisor, 100, 100000))
        return "the divisor of the billed weight runs from 100 to 100000 cm3 per kg";
    return {};
}

}  // namespace

double millimetres(Unit unit) {
    switch (unit) {
        case Unit::mm:
            return 1;
        case Unit::cm:
            return 10;
        case Unit::m:
            return 1000;
        case Unit::in:
            return 25.4;
    }
    return 1;
}

std::string_view unit_name(Unit unit) {
    switch (unit) {
        case Unit::mm:
            return "mm";
        case Unit::cm:
            return "cm";
        case Unit::m:
            return "m";
        case Unit::in:
            return "in";
    }
    return "mm";
}

std::optional<Unit> unit_from_name(std::string_view name) {
    for (const Unit unit : kUnits)
        if (unit_name(unit) == name) return unit;
    return {};
}

Walls wanted_wall_mm(const SpaceOptions& space) {
    return space.wall_mm.value_or(equal_walls(space.blocks ? 0 : 50));
}

Result<Design> checked(Design design) {
    design.cut.stud_mm = design.workshop.work == Workshop::bricks ? kStudHeight : 0;
    Problem found = problem(design.object);
    if (!found) found = problem(design.space);
    if (!found) found = problem(design.placement);
    if (!found) found = problem(design.cut, design.space.block_mm);
    if (!found) found = problem(design.parting, design.space, design.case_options.inside_mm.has_value());
    if (!found) found = problem(design.output);
    if (!found) found = problem_of(design.case_options);
    if (!found) found = problem_of(design.fit);
    if (!found) found = problem(design.search);
    if (!found) found = problem_of(design.workshop);
    if (found) return fail(ErrorKind::usage, *found);
    return design;
}

}  // namespace snug
