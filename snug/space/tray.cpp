#include "snug/space/tray.h"

#include <algorithm>
#include <cmath>

namespace snug {
namespace {

/// Where the surface must be for this item.
double surface_of(double open, const Item& item) {
    return item.placement.bounds.min.x + sunk_mm(open, item.placement.bounds);
}

}  // namespace

double sunk_mm(double open, const Box3d& placed) {
    const double height = placed.size().x;
    return open <= 1 ? open * height : std::min(open, height);
}

int tray_level(double open, const std::vector<Item>& uppermost, const DesignSpace& space) {
    double surface = space.face(0, 1);
    for (const Item& item : uppermost) surface = std::max(surface, surface_of(open, item));
    const double level = std::round((surface - space.face(0, 0)) / space.block_mm.x);
    return std::clamp(static_cast<int>(level), 1, space.blocks.x);
}

void sink_alike(double open, const std::vector<Item*>& layer) {
    if (layer.empty()) return;
    double surface = surface_of(open, *layer.front());
    for (const Item* item : layer) surface = std::max(surface, surface_of(open, *item));
    for (Item* item : layer) move(*item, {surface - surface_of(open, *item), 0, 0});
}

double rise_to_floor(const std::vector<Item>& items, double floor_x, double floor_mm, double block_mm) {
    const double floor = std::ceil(floor_mm / block_mm - 1e-9) * block_mm;
    return floor_x + floor - room_of(items).min.x;
}

}  // namespace snug
