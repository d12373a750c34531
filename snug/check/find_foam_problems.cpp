#include "snug/check/find_foam_problems.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/check/find_case_problems.h"
#include "snug/check/find_edits.h"
#include "snug/check/find_problems.h"
#include "snug/design/presets.h"
#include "snug/space/fitted_space.h"
#include "snug/space/tray.h"
#include "snug/words/pieces.h"

namespace snug {
namespace {

std::optional<Finding> outside_of(const Box3d& placed, const DesignSpace& space, const Clearance& clearance) {
    const Box3d room = grown(placed, clearance);
    const Vec3d least = fitted_blocks(room, space.block_mm);
    if (least.x <= space.blocks.x && least.y <= space.blocks.y && least.z <= space.blocks.z) return {};
    const Vec3d least_mm{least.x * space.block_mm.x, least.y * space.block_mm.y, least.z * space.block_mm.z};
    return Finding{Severity::danger,
                   say("outside", {{"needed", dimensions(room.size())},
                                   {"clearance", with_clearance(clearance)},
                                   {"space", dimensions(space.size())},
                                   {"space_blocks", dimensions(vec_cast<double>(space.blocks), 0)},
                                   {"least_blocks", dimensions(least, 0)},
                                   {"least", dimensions(least_mm)}}),
                   placed.centre()};
}

/// Of a plain space. Away from its centre the space must grow on both sides.
Message too_small_for_items(const DesignSpace& space, const Box3d& room, const Clearance& clearance) {
    const Vec3d least = fitted_blocks(room, space.block_mm);
    const Vec3d least_mm{least.x * space.block_mm.x, least.y * space.block_mm.y, least.z * space.block_mm.z};
    return say("outside/items", {{"space", dimensions(space.size())},
                                 {"space_blocks", dimensions(vec_cast<double>(space.blocks), 0)},
                                 {"needed", dimensions(room.size())},
                                 {"clearance", with_clearance(clearance)},
                                 {"least_blocks", dimensions(least, 0)},
                                 {"least", dimensions(least_mm)},
                                 {"example", kPlacedItem}});
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

/// Above the inside of its case.
bool too_high_for_tray(const Item& item, const Packing& packing, std::vector<Finding>& findings) {
    if (!packing.fitted_case) return false;
    auto why = too_high_for_case(item, *packing.fitted_case, packing.space);
    if (!why) return false;
    findings.push_back({Severity::danger, std::move(*why), item.placement.bounds.centre()});
    return true;
}

double squared_distance(const Box3d& box, Vec3d p) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double off = std::max({box.min[axis] - p[axis], 0.0, p[axis] - box.max[axis]});
        sum += off * off;
    }
    return sum;
}

/// Findings from `begin` on that have a place are of the item that is nearest to it, where there are several.
void name_nearest(const std::vector<Item>& items, std::size_t begin, std::vector<Finding>& findings) {
    for (std::size_t i = begin; i < findings.size() && items.size() > 1; ++i) {
        if (!findings[i].where) continue;
        const auto nearest = std::min_element(items.begin(), items.end(), [&](const Item& a, const Item& b) {
            return squared_distance(a.placement.bounds, *findings[i].where) <
                   squared_distance(b.placement.bounds, *findings[i].where);
        });
        findings[i].of = nearest->name;
    }
}

}  // namespace

void find_outside(const Item& item, const Packing& packing, const Design& design,
                  std::vector<Finding>& findings) {
    const Clearance clearance = item.cut.whole_clearance_mm();
    Box3d placed = item.placement.bounds;
    if (design.space.open) {
        if (too_high_for_tray(item, packing, findings)) return;
        // What stands out of a tray needs no foam around it.
        placed.max.x = std::min(placed.max.x, packing.space.box().max.x - clearance.upper.x);
    }
    auto finding = outside_of(placed, packing.space, clearance);
    if (!finding) return;
    const Walls walls = wanted_wall_mm(design.space);
    const bool alone = packing.items.size() == 1;
    if (!alone && packing.fitted_case)
        finding->message = too_small_for_items(*packing.fitted_case, room_of(packing.items),
                                               with_clearance(clearance), walls);
    else if (!alone)
        finding->message = too_small_for_items(packing.space, room_of(packing.items), clearance);
    else if (packing.fitted_case)
        finding->message = too_small(*packing.fitted_case, item.placement.bounds.size(), clearance, walls);
    findings.push_back(std::move(*finding));
}

void find_foam_problems(const Packing& packing, const Design& design, std::vector<Finding>& findings) {
    const SpaceChoice choice = choice_of(packing, design);
    const std::size_t before = findings.size();
    find_thin_walls(packing.fit, packing.layers, packing.space, wanted_wall_mm(design.space),
                    !is_rigid(design), choice, findings);
    name_nearest(packing.items, before, findings);
    find_pieces(packing.fit, choice, findings);
    if (design.fit.notches && design.fit.notches->depth_mm < kFingerDepth && packing.items.size() > 1)
        findings.push_back(
            {Severity::warning, say("notches_shallow", {{"depth_mm", number(design.fit.notches->depth_mm, 1)},
                                                        {"wanted_mm", number(kFingerDepth, 0)}})});
    find_edits(packing, design.edits, findings);
    for (const Piece piece : packing.lift.without)
        findings.push_back({Severity::warning, say("no_lift", {{"foam", foam_of(piece)}})});
    if (packing.fitted_case)
        find_case_problems(*packing.fitted_case, packing.fit, packing.foams->parting.back(), findings);
}

}  // namespace snug
