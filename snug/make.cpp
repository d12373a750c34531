#include "snug/make.h"

#include <string>
#include <utility>

#include "snug/base/stopwatch.h"
#include "snug/check/find_foam_problems.h"
#include "snug/check/find_object_problems.h"
#include "snug/depth/object_depths.h"
#include "snug/foam/object_cut.h"
#include "snug/foam/parting.h"
#include "snug/foam/ribs.h"
#include "snug/space/place_object.h"
#include "snug/space/space_for.h"

namespace snug {
namespace {

/// Where the object lies, and which blocks there are around it.
Result<Packing> placed(const Object& object, const Design& design, const Progress& progress) {
    Packing packing;
    packing.rotation_deg = design.placement.rotation_deg;
    packing.offset_mm = design.placement.offset_mm;
    const bool in_case = design.case_options.inside_mm.has_value();
    const Vec3d offset = packing.offset_mm + shift_between_walls(design.space, in_case);
    const auto placement = place(object, packing.rotation_deg, offset, progress);
    if (!placement) return tl::unexpected(placement.error());
    packing.placement = *placement;
    auto room = space_for(packing.placement.bounds, design);
    if (!room) return tl::unexpected(room.error());
    packing.space = room->space;
    packing.fitted_case = std::move(room->fitted_case);
    packing.available = std::move(room->available);
    return packing;
}

/// As chosen, or at the line of the case's lid, or the best one.
Result<int> parting_level(const Packing& packing, const HalfCuts& cuts, const PartingOptions& options) {
    const int nx = packing.space.blocks.x;
    if (options.level && *options.level > nx)
        return fail(ErrorKind::usage, say("parting.too_high", {{"level", std::to_string(*options.level)},
                                                               {"blocks", std::to_string(nx)}}));
    if (options.level) return *options.level;
    if (packing.fitted_case && packing.fitted_case->lid_level) return *packing.fitted_case->lid_level;
    return auto_parting_level(cut_by_either(cuts), packing.space, packing.placement.bounds);
}

/// Takes more foam away than the object needs, so that the rest can be worked and the object lifted.
void cut_for_hands(Packing& packing, const Design& design, int level) {
    if (design.fit.notches) {
        const NotchPair pair = cut_notches(packing.blocks, packing.space, level, *design.fit.notches,
                                           wanted_wall_mm(design.space));
        if (pair.notches) packing.notches.assign(pair.notches->begin(), pair.notches->end());
        if (!pair.notches) packing.findings.push_back({Severity::warning, pair.why_not});
    }
    if (design.fit.least_rib_mm > 0)
        packing.rib_blocks = cut_thin_ribs(packing.blocks, packing.space, level, design.fit.least_rib_mm);
}

void add_findings(const std::vector<Finding>& more, std::vector<Finding>& findings) {
    findings.insert(findings.end(), more.begin(), more.end());
    sort_by_severity(findings);
}

/// Figures of a search with a stand-in are the stand-in's.
void note_stand_in(Packing& packing) {
    add_findings({{Severity::note, say("searched_stand_in")}}, packing.findings);
}

Progress told(const Tools& tools, Stage stage) {
    return tools.progress ? tools.progress(stage) : Progress();
}

}  // namespace

Result<Packing> pack(const Object& object, const Design& design, const Progress& progress) {
    auto packing = placed(object, design, part_of(progress, 0, 0.4));
    if (!packing) return packing;
    if (const auto finding = find_outside(*packing, design)) {
        packing->findings.push_back(*finding);
        return packing;
    }
    const DesignSpace& space = packing->space;
    Stopwatch watch;
    const auto depths =
        object_depths(object, packing->placement, space, design.cut, part_of(progress, 0.4, 1));
    if (!depths) return tl::unexpected(depths.error());
    packing->timing.depth_map = watch.lap();

    const HalfCuts cuts = half_cuts(*depths, space);
    packing->timing.block_map = watch.lap();

    const auto level = parting_level(*packing, cuts, design.parting);
    if (!level) return tl::unexpected(level.error());
    packing->blocks = cut_by_both(cuts, *level);
    cut_for_hands(*packing, design, *level);
    packing->foams = split(packing->blocks, *level, packing->available);
    packing->timing.foam_pair = watch.lap();

    packing->fit = fit_report(*packing->foams, packing->blocks, space, packing->available);
    std::vector<Finding>& findings = packing->findings;
    find_object_problems(object, packing->placement, space, *depths, cuts, findings);
    find_foam_problems(*packing, design, findings);
    find_object_notes(object, packing->placement, design.object, findings);
    sort_by_severity(findings);
    return packing;
}

Result<Made> make(Object& object, Project& project, const Tools& tools) {
    Made made;
    made.language = tools.language;
    Design& design = project.design;
    if (tools.search) {
        auto found = tools.search(object, design);
        if (!found) return tl::unexpected(found.error());
        made.search = std::move(*found);
    }

    auto packing = pack(object, design, told(tools, Stage::cut));
    if (!packing) return tl::unexpected(packing.error());
    made.packing = std::move(*packing);
    take_stand_in(object);
    if (made.search && !object.whole()) note_stand_in(made.packing);
    if (!made.packing.foams) return made;

    if (design.workshop.work != Workshop::none) {
        auto pack = workshop_pack(object, made.packing, project,
                                  {tools.solve_lp, told(tools, Stage::workshop), tools.language});
        if (!pack) return tl::unexpected(pack.error());
        made.pack = std::move(*pack);
        add_findings(made.pack->findings, made.packing.findings);
    }

    auto fit = measure_fit(object, made.packing, design, told(tools, Stage::gaps));
    if (!fit) return tl::unexpected(fit.error());
    made.fit = std::move(*fit);
    return made;
}

}  // namespace snug
