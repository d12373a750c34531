#include "snug/space/tray.h"

#include <algorithm>
#include <cmath>

#include "snug/base/text.h"

namespace snug {
namespace {

/// Where the surface must be for this item, had it no offset along x.
double surface_of(double open, const Item& item) {
    return item.placement.bounds.min.x - item.offset_mm.x + sunk_mm(open, item.placement.bounds);
}

/// What it takes up, had it no offset along x.
Box3d settled_room(const Item& item) {
    const Vec3d off{item.offset_mm.x, 0, 0};
    const Box3d room = room_of(item);
    return {room.min - off, room.max - off};
}

int layers_of(const std::vector<Item>& items) {
    int layers = 1;
    for (const Item& item : items) layers = std::max(layers, item.layer);
    return layers;
}

}  // namespace

double sunk_mm(double open, const Box3d& placed) {
    const double height = placed.size().x;
    return open <= 1 ? open * height : std::min(open, height);
}

double reached_mm(const Item& item, int level, const DesignSpace& space) {
    return space.face(0, level) - item.placement.bounds.min.x + item.offset_mm.x;
}

int tray_level(double open, const std::vector<Item>& uppermost, const DesignSpace& space) {
    double surface = space.face(0, 1);
    for (const Item& item : uppermost) surface = std::max(surface, surface_of(open, item));
    const double level = std::ceil((surface - space.face(0, 0)) / space.block_mm.x - 1e-9);
    return std::clamp(static_cast<int>(level), 1, space.blocks.x);
}

void settle_in_tray(std::vector<Item>& items, double open, double apart_mm) {
    double top = 0;  // of the next layer
    for (int layer = layers_of(items); layer > 0; --layer) {
        double lowest = top;
        for (Item& item : items) {
            if (item.layer != layer) continue;
            const bool uppermost = layer == layers_of(items);
            raise(item, uppermost ? -surface_of(open, item) : top - settled_room(item).max.x);
            lowest = std::min(lowest, settled_room(item).min.x);
        }
        top = lowest - apart_mm;
    }
}

double rise_to_floor(const std::vector<Item>& items, double floor_x, double floor_mm, double block_mm) {
    const double floor = std::ceil(floor_mm / block_mm - 1e-9) * block_mm;
    double lowest = settled_room(items.front()).min.x;
    for (const Item& item : items) lowest = std::min(lowest, settled_room(item).min.x);
    return floor_x + floor - lowest;
}

std::optional<Message> too_high_for_case(const Item& item, const CaseSpace& fitted,
                                         const DesignSpace& space) {
    const double top = fitted.free.max.x, floor = space.box().min.x;
    if (item.placement.bounds.max.x <= top + 0.01) return {};
    const double lowest = item.placement.bounds.min.x - item.cut.whole_clearance_mm().lower.x;
    return say("outside/tray", {{"floor_mm", number(lowest - floor, 1)},
                                {"height_mm", number(item.placement.bounds.max.x - lowest, 1)},
                                {"inside_mm", number(top - floor, 1)}});
}

}  // namespace snug
