#include "snug/search/searched_zones.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "snug/object/prepare.h"
#include "snug/object/zone_surface.h"
#include "snug/space/place_zones.h"

namespace snug {
namespace {

/// What of the object's own mesh lies in a zone, as an object of its own.
Object of_own_mesh(const Object& object, const Zone& zone) {
    Object part;
    part.name = object.name;
    part.mesh = zone_of_mesh(object, zone);
    part.measure.bounds = bounds(part.mesh);
    return part;
}

}  // namespace

Result<std::vector<ItemZone>> searched_zones(const Object& object, const Zones& zones) {
    auto placed = place_zones(object, zones, {});
    if (!placed) return tl::unexpected(placed.error());
    std::erase_if(*placed, [](const ItemZone& zone) { return zone.asked.keep_off_mm <= 0; });
    for (ItemZone& zone : *placed) {
        Object part = object.whole() ? *zone.surface : of_own_mesh(object, zone.asked);
        if (!object.whole()) zone.stands_for = zone.surface->measure.bounds;
        if (!part.mesh.triangles.empty()) prepare_for_many(part);
        zone.surface = std::make_shared<const Object>(std::move(part));
        zone.asked.balls.clear();
    }
    return placed;
}

Result<std::vector<ItemZone>> searched_zones(const Object& object, const Design& design) {
    return searched_zones(object, zones_of(design.items.front(), design));
}

Item lying(const Placement& placement, const CutOptions& cut, const std::vector<ItemZone>& zones) {
    Item item;
    item.cut = cut;
    item.placement = placement;
    item.zones = place_zones(zones, placement);
    return item;
}

Item lying(const PreparedSurface& surface, const CutOptions& cut, const std::vector<ItemZone>& zones,
           Vec3d rotation_deg, Vec3d offset_mm) {
    Item item = lying(place(surface, rotation_deg, offset_mm), cut, zones);
    item.rotation_deg = rotation_deg;
    item.offset_mm = offset_mm;
    return item;
}

}  // namespace snug
