#include "snug/space/item.h"

namespace snug {
namespace {

Box3d shifted(const Box3d& box, Vec3d by) {
    return {box.min + by, box.max + by};
}

void shift(Item& item, Vec3d by) {
    item.placement.shift = item.placement.shift + by;
    item.placement.bounds = shifted(item.placement.bounds, by);
    for (ItemZone& zone : item.zones) zone.bounds = shifted(zone.bounds, by);
}

}  // namespace

void move(Item& item, Vec3d by) {
    item.offset_mm = item.offset_mm + by;
    shift(item, by);
}

void raise(Item& item, double mm) {
    item.rise_mm += mm;
    shift(item, {mm, 0, 0});
}

void settle(Item& item, double mm) {
    item.settled_mm += mm;
    shift(item, {-mm, 0, 0});
}

Box3d kept_free_by_zones(const Item& item) {
    Box3d room;
    for (const ItemZone& zone : item.zones)
        if (zone.asked.keep_off_mm > 0) room.include(grown(zone.bounds, zone.clearance_mm(item.cut)));
    return room;
}

Box3d room_of(const Item& item) {
    Box3d room = grown(item.placement.bounds, item.cut.whole_clearance_mm());
    room.include(kept_free_by_zones(item));
    return room;
}

Box3d room_of(const std::vector<Item>& items) {
    Box3d room;
    for (const Item& item : items) room.include(room_of(item));
    return room;
}

std::vector<NumberedPlace> numbered_places(const std::vector<Item>& items, int layer) {
    std::vector<NumberedPlace> places;
    for (std::size_t i = 0; i < items.size() && items.size() > 1; ++i)
        if (items[i].layer == layer) places.push_back({i + 1, items[i].placement.bounds.centre()});
    return places;
}

std::vector<Item> of_layer(const std::vector<Item>& items, int layer) {
    std::vector<Item> own;
    for (const Item& item : items)
        if (item.layer == layer) own.push_back(item);
    return own;
}

Box3d bounds_of(const std::vector<Item>& items) {
    Box3d bounds;
    for (const Item& item : items) bounds.include(item.placement.bounds);
    return bounds;
}

}  // namespace snug
