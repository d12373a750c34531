#include "snug/pipeline.h"

#include <algorithm>
#include <string>
#include <utility>

#include "snug/base/stopwatch.h"
#include "snug/base/text.h"
#include "snug/foam/depth_map.h"
#include "snug/foam/find_case_problems.h"
#include "snug/foam/find_problems.h"
#include "snug/foam/fitted_space.h"
#include "snug/foam/parting.h"
#include "snug/mesh/cap.h"

namespace snug {
namespace {

constexpr double kLongestPlausible = 5000;  // mm

/// From the file's unit to millimetres.
double millimetres_per_unit(Vec3d size, const ObjectOptions& options) {
    if (options.longest_mm) return *options.longest_mm / std::max({size.x, size.y, size.z});
    return millimetres(options.units.value_or(Unit::mm)) * options.scale;
}

/// A space that is fitted to unequal walls does not have the object in its middle.
Vec3d shift_between_walls(const SpaceOptions& space, bool in_case) {
    return space.blocks || in_case ? Vec3d{} : fitted_shift(space.block_mm, wanted_wall_mm(space));
}

Placement placement_of(const Object& object, const PlacementOptions& options, Vec3d shift_mm) {
    const Vec3d offset = options.offset_mm + shift_mm;
    if (object.surface) return place(*object.surface, options.rotation_deg, offset);
    return place(object.mesh, options.rotation_deg, offset);
}

/// The design space, fitted to the placed object where the design leaves the counts open.
Result<DesignSpace> space_for(Box3d placed, const Design& design) {
    const SpaceOptions& options = design.space;
    if (options.blocks) return DesignSpace{*options.blocks, options.block_mm};
    const Vec3d shift = shift_between_walls(options, false);
    placed = {placed.min - shift, placed.max - shift};
    const Vec3d counts =
        fitted_blocks(placed, options.block_mm, design.cut.clearance_mm, wanted_wall_mm(options));
    if (std::max({counts.x, counts.y, counts.z}) > kMostBlocks)
        return fail(ErrorKind::usage, "the object and its walls would need " + dimensions(counts, 0) +
                                          " blocks, more than 4096 on an axis: choose larger blocks");
    return DesignSpace{vec_cast<int>(counts), options.block_mm};
}

/// Whether the object, grown by the clearance, leaves the space; a face that coincides with the space's does
/// not.
std::optional<Finding> outside(const Box3d& placed, const DesignSpace& space, double clearance_mm) {
    const Vec3d least = fitted_blocks(placed, space.block_mm, clearance_mm);
    if (least.x <= space.blocks.x && least.y <= space.blocks.y && least.z <= space.blocks.z) return {};
    const Vec3d least_mm{least.x * space.block_mm.x, least.y * space.block_mm.y, least.z * space.block_mm.z};
    const Vec3d grown_size = placed.size() + Vec3d{2, 2, 2} * clearance_mm;
    return Finding{Severity::danger, "outside",
                   "the object needs " + dimensions(grown_size) + " mm" +
                       (clearance_mm != 0 ? " with its clearance" : "") + " and leaves the design space of " +
                       dimensions(space.size()) + " mm (" + dimensions(vec_cast<double>(space.blocks), 0) +
                       " blocks). The smallest that would do here is " + dimensions(least, 0) + " blocks (" +
                       dimensions(least_mm) + " mm) without any wall; --blocks auto adds walls",
                   placed.centre()};
}

/// A case that is divided exactly may have smaller blocks than those the clearance was checked for.
std::optional<Error> too_squeezed(const DesignSpace& space, const CutOptions& cut) {
    const Vec3d block = space.block_mm;
    const double least = kLeastClearanceShare * std::min({block.x, block.y, block.z});
    if (cut.clearance_mm >= least) return {};
    return Error{ErrorKind::usage, "the case is divided into blocks of " + dimensions(block) +
                                       " mm, for which the clearance must be " + number(least, 4) +
                                       " mm or more (-0.4 of the smallest side), not " +
                                       number(cut.clearance_mm, 4)};
}

/// As chosen, or at the line of the case's lid, or the best one.
int parting_level(const Packing& packing, const PartingOptions& options) {
    if (options.level) return *options.level;
    if (packing.fitted_case && packing.fitted_case->lid_level) return *packing.fitted_case->lid_level;
    return auto_parting_level(packing.blocks, packing.space, packing.placement.bounds);
}

std::vector<Finding> findings_of(const Object& object, const Design& design, const Packing& packing,
                                 const DepthMap& depths, Reach reach) {
    std::vector<Finding> findings;
    const Placement& placement = packing.placement;
    const DesignSpace& space = packing.space;
    find_open_holes(object.hole_spans, placement, space, reach, depths, packing.blocks, findings);
    find_uncut_parts(object.mesh, object.measure, placement, space, reach, packing.blocks, findings);
    find_thin_walls(packing.fit, packing.blocks, space, wanted_wall_mm(design.space), findings);
    find_pieces(packing.fit, findings);
    if (packing.fitted_case)
        find_case_problems(*packing.fitted_case, packing.fit, packing.foams->parting_level, findings);
    find_parts(object.measure, placement, findings);
    if (object.capped)
        findings.push_back({Severity::note,
                            "capped",
                            counted(object.measure.holes.size(), "hole was", "holes were") +
                                " closed before cutting; where the surface is missing its shape is a guess",
                            {}});
    sort_by_severity(findings);
    return findings;
}

}  // namespace

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
    if (const auto error = implausible_size(size, design)) return tl::unexpected(*error);

    Object object;
    object.read_vertices = mesh.vertices.size();
    object.read_triangles = mesh.triangles.size();
    object.mesh = scaled(std::move(mesh), millimetres_per_unit(size, design.object));
    object.measure = measure(object.mesh);
    object.capped = design.object.cap && !object.measure.holes.empty();
    if (object.capped)
        object.mesh = capped(object.mesh, object.measure.holes);
    else
        object.hole_spans = span_of_loops(object.mesh, object.measure.holes);
    return object;
}

void prepare_for_many(Object& object) {
    if (!object.surface) object.surface = prepare_surface(object.mesh);
}

Result<Packing> pack(const Object& object, const Design& design) {
    Packing packing;
    const bool in_case = design.case_options.inside_mm.has_value();
    packing.rotation_deg = design.placement.rotation_deg;
    packing.offset_mm = design.placement.offset_mm;
    packing.placement = placement_of(object, design.placement, shift_between_walls(design.space, in_case));
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
    if (auto finding = outside(packing.placement.bounds, space, design.cut.clearance_mm)) {
        if (in_case)
            finding->message = too_small(*packing.fitted_case, packing.placement.bounds.size(),
                                         design.cut.clearance_mm, wanted_wall_mm(design.space));
        packing.findings.push_back(*finding);
        return packing;
    }

    const Reach grown = reach(design.cut.clearance_mm, design.cut.cut_on_touch);
    Stopwatch watch;
    const DepthMap depths = object.surface ? depth_map(*object.surface, packing.placement, space, grown)
                                           : depth_map(object.mesh, packing.placement, space, grown);
    packing.timing.depth_map = watch.lap();
    packing.blocks = block_map(depths, space, grown);
    packing.timing.block_map = watch.lap();

    const int level = parting_level(packing, design.parting);
    if (level > space.blocks.x)
        return fail(ErrorKind::usage, "the parting level " + std::to_string(level) +
                                          " is above the space's " + std::to_string(space.blocks.x) +
                                          " blocks");
    packing.foams = split(packing.blocks, space, level, packing.available);
    packing.timing.foam_pair = watch.lap();

    packing.fit = fit_report(*packing.foams, packing.blocks, space, packing.available);
    packing.findings = findings_of(object, design, packing, depths, grown);
    return packing;
}

Result<GapReport> gaps(const Object& object, const Packing& packing, const Progress& progress) {
    const bool closed = object.measure.watertight;
    return gap_report(object.mesh, packing.placement, packing.space, packing.blocks, closed, progress);
}

}  // namespace snug
