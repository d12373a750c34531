#include "snug/search/given_room.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "snug/base/side.h"
#include "snug/space/available.h"

namespace snug {
namespace {

/// Whether a column has all these blocks.
bool has(const Grid<Run>& available, int j, int k, int first, int end) {
    return available.contains(j, k) && available(j, k).first <= first && available(j, k).end >= end;
}

/// Whether a way, its first level, row and column there, has all blocks that it cuts, and all of its walls.
/// `whole`: where it is not known which levels it cuts, all of its layer.
bool stands_inside(const ItemWay& way, Vec3i at, const std::optional<Run>& whole, const BlockWalls& walls,
                   const Grid<Run>& available) {
    for (const MaskRun& run : runs_of(way.mask))
        for (int k = run.first; k < run.end; ++k) {
            const Run cut = way.cut(run.row, k);
            const int first = whole ? whole->first : at.x + cut.first,
                      end = whole ? whole->end : at.x + cut.end;
            const int row = at.y + run.row, column = at.z + k;
            if (first >= end) continue;
            if (!has(available, row, column, first - walls.side[kFloor], end + walls.side[kRoof]))
                return false;
            for (int j = row - walls.side[kBack]; j <= row + walls.side[kFront]; ++j)
                if (!has(available, j, column, first, end)) return false;
            for (int z = column - walls.side[kLeft]; z <= column + walls.side[kRight]; ++z)
                if (!has(available, row, z, first, end)) return false;
        }
    return true;
}

std::vector<BitMask> refused_places(const GivenRoom& given, const ItemMasks& masks, bool tray,
                                    const Grid<Run>& available) {
    const auto block = [](int level) { return static_cast<std::int16_t>(level); };
    std::vector<BitMask> refused;
    for (const ItemWay& way : masks.ways) {
        BitMask own(std::max(1, given.room.rows), std::max(1, given.room.columns));
        for (const LayerLevels& level : given.levels) {
            std::optional<Run> whole;
            if (tray)
                whole = Run{block(given.walls.side[kFloor]), block(given.space.blocks.x)};
            else if (way.halves_differ)
                whole = Run{block(level.first), block(level.first + level.height)};
            for (int j = 0; j + way.mask.rows() <= given.room.rows; ++j)
                for (int k = 0; k + way.mask.columns() <= given.room.columns; ++k)
                    if (!stands_inside(way,
                                       {level.first_of(way.height), j + given.walls.side[kBack],
                                        k + given.walls.side[kLeft]},
                                       whole, given.walls, available))
                        own.set(j, k);
        }
        refused.push_back(std::move(own));
    }
    return refused;
}

}  // namespace

GivenRoom given_room(const PackedSpace& given, const ItemMasks& masks, const Design& design,
                     const std::vector<int>& heights) {
    GivenRoom result{given.space, block_walls(design.space, given.space.block_mm), {}, {}};
    const Vec3i blocks = given.space.blocks;
    result.levels = layer_levels(heights, result.walls);
    // What is left stands half below them.
    const int left = blocks.x - height_of_layers(heights, result.walls);
    for (LayerLevels& level : result.levels) level.first += std::max(0, left / 2);
    if (given.fitted_case && given.fitted_case->lid_level && !design.space.open)
        result.levels.back().parting = *given.fitted_case->lid_level;
    result.room.rows = blocks.y - result.walls.along(1);
    result.room.columns = blocks.z - result.walls.along(2);
    result.room.heights = heights;
    if (design.space.open) {
        result.room.heights.assign(heights.size(), std::numeric_limits<int>::max());
        for (LayerLevels& level : result.levels) level.height = 0;
    }
    if (!fills_box(given.available, blocks.x))
        result.room.refused = refused_places(result, masks, design.space.open.has_value(), given.available);
    return result;
}

}  // namespace snug
