#include "snug/space/place_zones.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "snug/object/triangle_groups.h"
#include "snug/object/zone_surface.h"

namespace snug {
namespace {

/// Exact of a mesh; else its turned box, within the object's own.
Box3d placed_bounds(const Object& surface, const Placement& placement) {
    Box3d box;
    for (const Vec3f& vertex : surface.mesh.vertices) box.include(placement(vertex));
    if (!box.empty()) return box;
    box = reached(placement.rotation, placement.shift, surface.measure.bounds);
    for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = std::max(box.min[axis], placement.bounds.min[axis]);
        box.max[axis] = std::min(box.max[axis], placement.bounds.max[axis]);
    }
    return box;
}

}  // namespace

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
    for (ItemZone& zone : zones) zone.bounds = placed_bounds(*zone.surface, placement);
    return zones;
}

}  // namespace snug
