#pragma once

#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "snug/drawing/drawing.h"

namespace snug::test {

/// A drawing's items on one layer.
template <class Item>
std::vector<Item> items_on(const Drawing& drawing, const std::string& layer) {
    std::vector<Item> found;
    for (const DrawingItem& item : drawing.items)
        if (const auto* wanted = std::get_if<Item>(&item.what))
            if (drawing.layers.at(static_cast<std::size_t>(item.layer)).name == layer)
                found.push_back(*wanted);
    return found;
}

/// What a person reads off a map with a ruler: the foam's outline, and the cells whose middle lies in the
/// coloured rectangles.
struct ReadMap {
    Vec2d corner, size;
    std::set<std::pair<int, int>> cells;  ///< row, column, from the upper left
};

inline ReadMap read_map(const Drawing& drawing, const std::string& layer, int rows, int columns) {
    ReadMap map;
    const PathItem outline = items_on<PathItem>(drawing, "edge").front();
    map.corner = outline.lines.at(0).at(0);
    map.size = outline.lines.at(0).at(2) - map.corner;
    const double row_mm = map.size.y / rows, column_mm = map.size.x / columns;
    for (const PathItem& item : items_on<PathItem>(drawing, layer)) {
        if (!item.fill) continue;
        for (const auto& loop : item.lines) {
            const Vec2d from = loop.at(0) - map.corner, to = loop.at(2) - map.corner;
            for (int row = static_cast<int>(std::lround(from.y / row_mm)); row < std::lround(to.y / row_mm);
                 ++row)
                for (int column = static_cast<int>(std::lround(from.x / column_mm));
                     column < std::lround(to.x / column_mm); ++column)
                    map.cells.insert({row, column});
        }
    }
    return map;
}

}  // namespace snug::test
