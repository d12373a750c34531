#include "snug/space/place_zones.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

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
                                          const Placement& placement) {
    std::vector<ItemZone> placed;
    for (std::size_t i = 0; i < zones.size(); ++i) {
        auto surface = zone_surface(object, zones[i]);
        if (!surface)
            return fail(surface.error().kind, say("zone.numbered", {{"zone", std::to_string(i + 1)},
                                                                    {"why", surface.error().message}}));
        placed.push_back({zones[i], std::make_shared<const Object>(std::move(*surface)), {}});
    }
    return place_zones(std::move(placed), placement);
}

std::vector<ItemZone> place_zones(std::vector<ItemZone> zones, const Placement& placement) {
    for (ItemZone& zone : zones) zone.bounds = placed_bounds(zone, placement);
    return zones;
}

}  // namespace snug
