#include "snug/space/item.h"

namespace snug {

Box3d room_of(const Item& item) {
    return grown(item.placement.bounds, item.cut.whole_clearance_mm());
}

Box3d room_of(const std::vector<Item>& items) {
    Box3d room;
    for (const Item& item : items) room.include(room_of(item));
    return room;
}

std::vector<Vec3d> numbered_places(const std::vector<Item>& items) {
    std::vector<Vec3d> places;
    if (items.size() > 1)
        for (const Item& item : items) places.push_back(item.placement.bounds.centre());
    return places;
}

Box3d bounds_of(const std::vector<Item>& items) {
    Box3d bounds;
    for (const Item& item : items) bounds.include(item.placement.bounds);
    return bounds;
}

}  // namespace snug
