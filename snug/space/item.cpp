#include "snug/space/item.h"

namespace snug {

void move(Item& item, Vec3d by) {
    item.offset_mm = item.offset_mm + by;
    item.placement.shift = item.placement.shift + by;
    item.placement.bounds = {item.placement.bounds.min + by, item.placement.bounds.max + by};
}

Box3d room_of(const Item& item) {
    return grown(item.placement.bounds, item.cut.whole_clearance_mm());
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

std::string names_of_layer(const std::vector<Item>& items, int layer) {
    const std::vector<Item> own = of_layer(items, layer);
    std::string names;
    if (own.size() == items.size()) return names;
    for (const Item& item : own) names += (names.empty() ? "" : ", ") + item.name;
    return names;
}

Box3d bounds_of(const std::vector<Item>& items) {
    Box3d bounds;
    for (const Item& item : items) bounds.include(item.placement.bounds);
    return bounds;
}

}  // namespace snug
