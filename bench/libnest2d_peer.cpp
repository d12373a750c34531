#include "bench/libnest2d_peer.h"

#include <algorithm>
#include <cmath>
#include <libnest2d/libnest2d.hpp>

namespace snug::bench {

bool libnest2d_holds(const std::vector<PeerOutline>& outlines, double width, double height, int turns) {
    using namespace libnest2d;
    const double scale = 1e8 / std::max(width, height);
    const auto whole = [&](double length) { return static_cast<Coord>(std::llround(length * scale)); };
    std::vector<Item> items;
    for (const PeerOutline& outline : outlines) {
        ClipperLib::Path path;
        for (const auto& [x, y] : outline) path.emplace_back(whole(x), whole(y));
        if (ClipperLib::Orientation(path)) std::reverse(path.begin(), path.end());
        path.push_back(path.front());
        items.emplace_back(std::move(path));
    }
    NestConfig<> config;
    config.placer_config.rotations.clear();
    for (int i = 0; i < turns; ++i) config.placer_config.rotations.push_back(2 * Pi * i / turns);
    config.placer_config.parallel = false;
    // A little more than the rectangle: what is laid edge to edge is refused otherwise.
    const Box bin(whole(width) + 1000, whole(height) + 1000);
    return nest(items, bin, 0, config) == 1 &&
           std::all_of(items.begin(), items.end(), [](const Item& item) { return item.binId() == 0; });
}

}  // namespace snug::bench
