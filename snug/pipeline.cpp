#include "snug/pipeline.h"

#include <algorithm>
#include <string>
#include <utility>

#include "snug/base/stopwatch.h"
#include "snug/base/text.h"
#include "snug/check/find_case_problems.h"
#include "snug/check/find_problems.h"
#include "snug/foam/object_cut.h"
#include "snug/foam/parting.h"
#include "snug/foam/ribs.h"
#include "snug/foam/space_for.h"
#include "snug/mesh/cap.h"
#include "snug/object/read_findings.h"
#include "snug/pack_cloud.h"
#include "snug/pack_placed.h"
#include "snug/space/fitted_space.h"

namespace snug {
namespace {

constexpr double kLongestPlausible = 5000;  // mm

Placement placement_of(const Object& object, const PlacementOptions& options, Vec3d shift_mm) {
    const Vec3d offset = options.offset_mm + shift_mm;
    if (object.surface) return place(*object.surface, options.rotation_deg, offset);
    return place(object.mesh, options.rotation_deg, offset);
}

/// Whether the object, grown by the clearance, leaves the space; a face that coincides with the space's does
/// not.
std::optional<Finding> outside(const Box3d& placed, const DesignSpace& space, const Clearance& clearance) {
    const Box3d room = grown(placed, clearance);
    const Vec3d least = fitted_blocks(room, space.block_mm);
    if (least.x <= space.blocks.x && least.y <= space.blocks.y && least.z <= space.blocks.z) return {};
    const Vec3d least_mm{least.x * space.block_mm.x, least.y * space.block_mm.y, least.z * space.block_mm.z};
    return Finding{Severity::danger, "outside",
                   "the object needs " + dimensions(room.size()) + " mm" +
                       (clearance != Clearance() ? " with its clearance" : "") +
                       " and leaves the design space of " + dimensions(space.size()) + " mm (" +
                       dimensions(vec_cast<double>(space.blocks), 0) +
                       " blocks). The smallest that would do here is " + dimensions(least, 0) + " blocks (" +
                       dimensions(least_mm) + " mm) without any wall; --blocks auto adds walls",
                   placed.centre()};
}

/// A case that is divided exactly may have smaller blocks than those the clearance was checked for.
std::optional<Error> too_squeezed(const DesignSpace& space, const CutOptions& cut) {
    const Vec3d block = space.block_mm;
    const double least = kLeastClearanceShare * std::min({block.x, block.y, block.z});
    if (cut.whole_clearance_mm().least() >= least) return {};
    return Error{ErrorKind::usage, "the case is divided into blocks of " + dimensions(block) +
                                       " mm, for which the clearance must be " + number(least, 4) +
                                       " mm or more (-0.4 of the smallest side), not " +
                                       number(cut.whole_clearance_mm().least(), 4)};
}

/// As chosen, or at the line of the case's lid, or the best one.
int parting_level(const Packing& packing, const HalfCuts& cuts, const PartingOptions& options) {
    if (options.level) return *options.level;
    if (packing.fitted_case && packing.fitted_case->lid_level) return *packing.fitted_case->lid_level;
    return auto_parting_level(cut_by_either(cuts), packing.space, packing.placement.bounds);
}

/// What may be wrong with the object in one half.
void find_problems_of_half(const Object& object, const Placement& placement, const DesignSpace& space,
                           const HalfDepths& half, const BlockMap& cut, std::vector<Finding>& findings) {
    find_open_holes(object.hole_spans, placement, space, half.reach, half.depths, cut, findings);
    find_uncut_parts(object.mesh, object.measure, object.capped, placement, space, half.reach, cut, findings);
}

/// Takes more foam away than the object needs, so that the rest can be worked and the object lifted.
void shape(Packing& packing, const Design& design, int level) {
    if (design.fit.notches) {
        const NotchPair pair = cut_notches(packing.blocks, packing.space, level, *design.fit.notches,
                                           wanted_wall_mm(design.space));
        if (pair.notches) packing.notches.assign(pair.notches->begin(), pair.notches->end());
        if (!pair.notches) packing.findings.push_back({Severity::warning, "no_notches", pair.why_not, {}});
    }
    if (design.fit.least_rib_mm > 0)
        packing.rib_blocks = cut_thin_ribs(packing.blocks, packing.space, level, design.fit.least_rib_mm);
}

SpaceChoice choice_of(const Packing& packing, const Design& design) {
    SpaceChoice choice{SpaceChoice::Kind::blocks, wanted_wall_mm(design.space), design.placement.offset_mm,
                       design.case_options.inside_mm};
    const CaseOptions& given = design.case_options;
    if (packing.fitted_case)
        choice.kind = given.corner_radius_mm > 0 || given.base_mm || given.top_mm ? SpaceChoice::Kind::shaped
                                                                                  : SpaceChoice::Kind::box;
    else if (!design.space.blocks)
        choice.kind = SpaceChoice::Kind::fitted;
    return choice;
}

/// What may be wrong with the foams, whatever they are for.
void find_foam_problems(const Packing& packing, const Design& design, std::vector<Finding>& findings) {
    const SpaceChoice choice = choice_of(packing, design);
    find_thin_walls(packing.fit, packing.blocks, packing.space, wanted_wall_mm(design.space), choice,
                    findings);
    find_pieces(packing.fit, choice, findings);
    if (packing.fitted_case)
        find_case_problems(*packing.fitted_case, packing.fit, packing.foams->parting_level, findings);
}

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
    std::string sentence = "the object would be " + dimensions(mm, 3) + " mm, " +
                           (tiny ? "smaller than one block" : "longer than 5 m") +
                           ". Which unit is it in? Read as ";
    for (const Unit unit : {Unit::mm, Unit::cm, Unit::m, Unit::in})
        sentence += std::string(unit == Unit::mm   ? ""
                                : unit == Unit::in ? ", or as "
                                                   : ", as ") +
                    std::string(unit_name(unit)) + " it measures " + dimensions(mm * millimetres(unit), 1) +
                    " mm";
    return Error{ErrorKind::input, sentence + ". Choose with --units mm|cm|m|in"};
}

Result<Object> prepare(Mesh mesh, const Design& design) {
    const Vec3d size = bounds(mesh).size();
    if (std::max({size.x, size.y, size.z}) <= 0)
        return fail(ErrorKind::input, "the object has no size: all its points are one");
    if (!mesh.read.in_mm)
        if (const auto error = implausible_size(size, design)) return tl::unexpected(*error);

    Object object;
    const ReadNotes read = mesh.read;
    object.read_vertices = mesh.vertices.size();
    object.read_triangles = mesh.triangles.size();
    const double mm_per_unit = millimetres_per_unit(size, design.object, mesh.read.in_mm);
    auto clean = cleaned(scaled(std::move(mesh), mm_per_unit), design.object.clean);
    if (!clean) return tl::unexpected(clean.error());
    object.clean = std::move(clean->report);
    if (clean->mesh.is_cloud()) {
        auto cloud = prepare_cloud(std::move(object), std::move(clean->mesh), design);
        if (cloud) cloud->mesh.read = read;
        return cloud;
    }
    object.mesh = std::move(clean->mesh);
    object.measure = measure(object.mesh);
    object.parts =
        object.clean.parts.empty() ? part_shares(object.mesh, object.measure) : std::move(object.clean.parts);
    object.capped = design.object.cap && !object.measure.holes.empty();
    if (object.capped)
        object.mesh = capped(object.mesh, object.measure.holes);
    else
        object.hole_spans = span_of_loops(object.mesh, object.measure.holes);
    object.mesh.read = read;
    return object;
}

void prepare_for_many(Object& object) {
    if (!object.surface) object.surface = prepare_surface(object.mesh);
}

Result<Packing> pack_placed(const Placement& placement, const Design& design, const PackSteps& steps) {
    Packing packing;
    const bool in_case = design.case_options.inside_mm.has_value();
    packing.rotation_deg = design.placement.rotation_deg;
    packing.offset_mm = design.placement.offset_mm;
    packing.placement = placement;
    if (in_case) {
        auto fitted = case_space(design.case_options, design.space.block_mm);
        if (!fitted) return tl::unexpected(fitted.error());
        if (const auto error = too_squeezed(fitted->space, design.cut)) return tl::unexpected(*error);
        packing.space = fitted->space;
        packing.available = available_blocks(*fitted);
        packing.fitted_case = std::move(*fitted);
    } else {
        const auto fitted = space_for(packing.placement.bounds, design);
        if (!fitted) return tl::unexpected(fitted.error());
        packing.space = *fitted;
    }
    const DesignSpace& space = packing.space;
    if (auto finding = outside(packing.placement.bounds, space, design.cut.whole_clearance_mm())) {
        if (in_case)
            finding->message = too_small(*packing.fitted_case, packing.placement.bounds.size(),
                                         design.cut.whole_clearance_mm(), wanted_wall_mm(design.space));
        packing.findings.push_back(*finding);
        return packing;
    }

    Stopwatch watch;
    const auto depths = steps.depths(packing.placement, space);
    if (!depths) return tl::unexpected(depths.error());
    packing.timing.depth_map = watch.lap();
    const HalfCuts cuts = half_cuts(*depths, space);
    packing.timing.block_map = watch.lap();

    const int level = parting_level(packing, cuts, design.parting);
    if (level > space.blocks.x)
        return fail(ErrorKind::usage, "the parting level " + std::to_string(level) +
                                          " is above the space's " + std::to_string(space.blocks.x) +
                                          " blocks");
    packing.blocks = cut_by_both(cuts, level);
    shape(packing, design, level);
    packing.foams = split(packing.blocks, space, level, packing.available);
    packing.timing.foam_pair = watch.lap();

    packing.fit = fit_report(*packing.foams, packing.blocks, space);
    steps.find_object_problems(packing, *depths, cuts, packing.findings);
    find_foam_problems(packing, design, packing.findings);
    steps.find_object_notes(packing, packing.findings);
    sort_by_severity(packing.findings);
    return packing;
}

Result<Packing> pack(const Object& object, const Design& design) {
    if (object.kind == ObjectKind::cloud) return pack_cloud(object, design);
    PackSteps steps;
    steps.depths = [&](const Placement& placement, const DesignSpace& space) -> Result<ObjectDepths> {
        return object.surface ? object_depths(*object.surface, placement, space, design.cut)
                              : object_depths(object.mesh, placement, space, design.cut);
    };
    steps.find_object_problems = [&](const Packing& packing, const ObjectDepths& depths, const HalfCuts& cuts,
                                     std::vector<Finding>& findings) {
        const std::size_t before = findings.size();
        find_problems_of_half(object, packing.placement, packing.space, depths.lower, cuts.lower, findings);
        if (depths.upper && findings.size() == before)
            find_problems_of_half(object, packing.placement, packing.space, *depths.upper, *cuts.upper,
                                  findings);
    };
    steps.find_object_notes = [&](const Packing& packing, std::vector<Finding>& findings) {
        find_parts(object.measure, packing.placement, findings);
        find_read_notes(object.mesh.read, 0, design.object.units, findings);
        find_dropped(object.clean, design.object.clean, findings);
        if (object.capped)
            findings.push_back(
                {Severity::note,
                 "capped",
                 counted(object.measure.holes.size(), "hole was", "holes were") +
                     " closed before cutting; where the surface is missing its shape is a guess",
                 {}});
        if (design.object.cap && !object.capped)
            findings.push_back({Severity::note,
                                "nothing_to_cap",
                                "the object has no holes, so there was nothing to close: the foams are the "
                                "same without --cap",
                                {}});
        if (design.object.point_radius_mm > 0)
            findings.push_back({Severity::note,
                                "no_points",
                                "a point radius was chosen, but the object is no cloud of points: it was not "
                                "used",
                                {}});
    };
    const bool in_case = design.case_options.inside_mm.has_value();
    return pack_placed(placement_of(object, design.placement, shift_between_walls(design.space, in_case)),
                       design, steps);
}

Result<GapReport> gaps(const Object& object, const Packing& packing, const Progress& progress) {
    const bool closed = object.measure.watertight;
    return gap_report(object.mesh, packing.placement, packing.space, packing.blocks,
                      packing.foams->parting_level, closed, progress);
}

Result<BearingReport> bearing(const Object& object, const Packing& packing, const Progress& progress) {
    return bearing_report(object.mesh, packing.placement, packing.space, *packing.foams, progress);
}

}  // namespace snug
