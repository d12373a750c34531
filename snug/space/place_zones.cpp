#include "snug/space/place_zones.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "snug/object/streamed_bounds.h"
#include "snug/object/triangle_groups.h"
#include "snug/object/turned_bounds.h"
#include "snug/object/zone_surface.h"

namespace snug {
namespace {

/// Exact of a mesh; else its turned box.
Box3d placed_bounds(const ItemZone& zone, const Placement& placement) {
    const Object& surface = *zone.surface;
    Box3d box;
    if (surface.prepared) {
        box = turned_bounds(surface.prepared->body, placement.rotation);
        box = {box.min + placement.shift, box.max + placement.shift};
    } else {
        for (const Vec3f& vertex : surface.mesh.vertices) box.include(placement(vertex));
    }
    if (zone.stands_for)
        box.include(placed_box(*zone.stands_for, placement));
    else if (box.empty())
        box = placed_box(surface.measure.bounds, placement);
    return box;
}

/// Exact of a stream as well, by a pass over its file.
Result<Box3d> looked_up_bounds(const ItemZone& zone, const Placement& placement, const Progress& progress) {
    const auto* const streamed = std::get_if<StreamedTriangles>(&zone.surface->surface);
    if (!streamed) return placed_bounds(zone, placement);
    const auto bounds = streamed_bounds(streamed->stream, streamed->to_object, placement.rotation, progress);
    if (!bounds) return tl::unexpected(bounds.error());
    return Box3d{bounds->turned.min + placement.shift, bounds->turned.max + placement.shift};
}

}  // namespace

Box3d placed_box(const Box3d& own, const Placement& placement) {
    Box3d box = reached(placement.rotation, placement.shift, own);
    for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = std::max(box.min[axis], placement.bounds.min[axis]);
        box.max[axis] = std::min(box.max[axis], placement.bounds.max[axis]);
    }
    return box;
}

Result<std::vector<ItemZone>> place_zones(const Object& object, const Zones& zones,
                                          const Placement& placement, const Progress& progress) {
    std::vector<ItemZone> placed;
    const double share = 1 / static_cast<double>(std::max<std::size_t>(zones.size(), 1));
    for (std::size_t i = 0; i < zones.size(); ++i) {
        const double done = static_cast<double>(i) * share;
        auto surface = zone_surface(object, zones[i], part_of(progress, done, done + share / 2));
        if (!surface && surface.error().kind == ErrorKind::usage)
            return fail(surface.error().kind, say("zone.numbered", {{"zone", std::to_string(i + 1)},
                                                                    {"why", surface.error().message}}));
        if (!surface) return tl::unexpected(surface.error());
        placed.push_back({zones[i], std::make_shared<const Object>(std::move(*surface)), {}});
        const auto bounds =
            looked_up_bounds(placed.back(), placement, part_of(progress, done + share / 2, done + share));
        if (!bounds) return tl::unexpected(bounds.error());
        placed.back().bounds = *bounds;
    }
    return placed;
}

std::vector<ItemZone> place_zones(std::vector<ItemZone> zones, const Placement& placement) {
    for (ItemZone& zone : zones) zone.bounds = placed_bounds(zone, placement);
    return zones;
}

}  // namespace snug
