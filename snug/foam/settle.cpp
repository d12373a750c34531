#include "snug/foam/settle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace snug {
namespace {

constexpr double kSettlingStep = 0.1;  // mm
constexpr double kNotYet = 0.005;      // mm above a block, so that it is not touched

/// The lowest block that each column of a layer loses to any of its items and their zones.
BlockMap united_below(const std::vector<Item>& items, std::span<const HalfCuts> cuts, int layer) {
    std::vector<const HalfCuts*> own;
    for (std::size_t i = 0; i < items.size(); ++i)
        if (items[i].layer == layer) own.push_back(&cuts[i]);
    return united(own).lower;
}

double free_below_mm(const Item& item, const ObjectDepths& depths, const BlockMap& layer,
                     const DesignSpace& space) {
    const HalfDepths& lower = depths.lower;
    const BlockMap own = block_map(lower.depths, space, lower.reach);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t column = 0; column < own.size(); ++column) {
        if (own[column].none() || own[column].first != layer[column].first) continue;
        least = std::min(least,
                         lower.depths[column].lowest - lower.reach.mm.x - space.face(0, own[column].first));
    }
    if (std::isinf(least)) return 0;
    // What its zones keep free stays in the space as well.
    least = std::min(least, room_of(item).min.x - space.face(0, 0));
    return std::max(0.0, std::floor((least - kNotYet) / kSettlingStep) * kSettlingStep);
}

}  // namespace

std::vector<double> free_below_mm(const std::vector<Item>& items,
                                  std::span<const std::shared_ptr<const ObjectDepths>> depths,
                                  std::span<const HalfCuts> cuts, const DesignSpace& space,
                                  const std::vector<bool>& fixed) {
    std::vector<BlockMap> layers;
    for (const Item& item : items)
        while (static_cast<int>(layers.size()) < item.layer)
            layers.push_back(united_below(items, cuts, static_cast<int>(layers.size()) + 1));
    std::vector<double> mm(items.size(), 0);
    for (std::size_t i = 0; i < items.size(); ++i)
        if (!fixed[i])
            mm[i] = free_below_mm(items[i], *depths[i], layers[static_cast<std::size_t>(items[i].layer) - 1],
                                  space);
    std::vector<double> together = mm;
    for (std::size_t i = 0; i < items.size(); ++i)
        for (std::size_t other = 0; other < items.size(); ++other)
            if (!items[i].group.empty() && items[i].group == items[other].group &&
                items[i].layer == items[other].layer)
                together[i] = std::min(together[i], mm[other]);
    return together;
}

}  // namespace snug
