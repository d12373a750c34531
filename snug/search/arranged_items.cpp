#include "snug/search/arranged_items.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "snug/base/side.h"
#include "snug/base/text.h"
#include "snug/search/searched_zones.h"
#include "snug/space/fitted_space.h"
#include "snug/space/place_items.h"

namespace snug {
namespace {

constexpr std::size_t kFewKinds = 6, kMostShapes = 320, kLeastWays = 8, kMostWays = 48;

/// What decides how an item may lie: items that have it in common share their ways.
struct Kind {
    std::size_t object;
    Vec3d rotation_deg;
    CutOptions cut;
    Zones asked;
    std::vector<ItemZone> zones;
    std::vector<int> shapes;
};

std::size_t kind_of(const Item& item, const Zones& asked, const std::vector<ItemZone>& zones,
                    std::vector<Kind>& kinds) {
    for (std::size_t i = 0; i < kinds.size(); ++i)
        if (kinds[i].object == item.object && kinds[i].rotation_deg == item.rotation_deg &&
            kinds[i].cut == item.cut && kinds[i].asked == asked)
            return i;
    kinds.push_back({item.object, item.rotation_deg, item.cut, asked, zones, {}});
    return kinds.size() - 1;
}

/// The zones of every item; items of one object that ask for the same share them.
Result<void> add_zones(std::span<const Object> objects, const Design& design, ItemMasks& masks) {
    for (std::size_t i = 0; i < masks.items.size(); ++i) {
        const Zones& asked = zones_of(design.items[i], design);
        std::size_t same = 0;
        while (same < i && !(masks.items[same].object == masks.items[i].object &&
                             zones_of(design.items[same], design) == asked))
            ++same;
        if (same < i) {
            masks.zones.push_back(masks.zones[same]);
            continue;
        }
        auto zones = searched_zones(objects[masks.items[i].object], asked);
        if (!zones) return tl::unexpected(zones.error());
        masks.zones.push_back(std::move(*zones));
    }
    return {};
}

int add_shape(ItemMasks& masks, ItemWay way) {
    masks.problem.shapes.push_back({way.mask, way.height, way.cut_blocks});
    masks.ways.push_back(std::move(way));
    return static_cast<int>(masks.ways.size()) - 1;
}

Result<void> add_ways(std::span<const Object> objects, const Design& design, std::vector<Kind>& kinds,
                      ItemMasks& masks, const Progress& progress) {
    const std::size_t most =
        std::clamp(kMostShapes / std::max<std::size_t>(1, kinds.size()), kLeastWays, kMostWays);
    // Each place takes a pass over the object: few kinds may take more of the time that there is.
    const int places = kinds.size() <= kFewKinds ? 4 : 3;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (!go_on(progress, static_cast<double>(i) / static_cast<double>(kinds.size())))
            return fail(ErrorKind::cancelled, say("cancelled"));
        Kind& kind = kinds[i];
        const Object& object = objects[kind.object];
        auto ways = ways_to_lay(object, kind.cut, masks.block_mm,
                                allowed_rotations(object, kind.rotation_deg, design.search), places, most,
                                kind.zones);
        if (!ways) return tl::unexpected(ways.error());
        for (ItemWay& way : *ways) kind.shapes.push_back(add_shape(masks, std::move(way)));
    }
    return {};
}

/// A number for each group.
std::vector<int> group_numbers(const std::vector<Item>& items, bool all_may_touch) {
    std::map<std::string, int> numbers;
    std::vector<int> of_each;
    for (const Item& item : items) {
        const int next = static_cast<int>(numbers.size());
        of_each.push_back(
            item.group.empty() || all_may_touch ? -1 : numbers.try_emplace(item.group, next).first->second);
    }
    return of_each;
}

/// In kg where all are known, or else by what each cuts.
std::vector<double> masses(const ItemMasks& masks) {
    std::vector<double> mass;
    const bool known = std::all_of(masks.items.begin(), masks.items.end(),
                                   [](const Item& item) { return item.mass_kg.has_value(); });
    for (std::size_t i = 0; i < masks.items.size(); ++i) {
        const MaskPiece& piece = masks.problem.pieces[i];
        const auto blocks =
            piece.shapes.empty() ? 1 : masks.ways[static_cast<std::size_t>(piece.shapes.front())].cut_blocks;
        mass.push_back(known ? *masks.items[i].mass_kg : static_cast<double>(blocks));
    }
    return mass;
}

Error locked_meet(const Item& one, const Item& other, double between) {
    return {ErrorKind::usage,
            say("arrange.locked_meet",
                {{"one", one.name}, {"other", other.name}, {"between", number(between, 1)}})};
}

/// To a millionth of a millimetre, as projects keep it.
double tidy(double mm) {
    return std::floor(mm * 1e6 + 0.5) / 1e6;
}

}  // namespace

BlockWalls block_walls(const SpaceOptions& space, Vec3d block_mm) {
    BlockWalls walls;
    const Walls wanted = wanted_wall_mm(space);
    for (std::size_t side = 0; side < walls.side.size(); ++side)
        walls.side[side] = whole_blocks(wanted[side], block_mm[static_cast<int>(side) / 2]);
    const double between = wanted_between_mm(space);
    walls.gap = {whole_blocks(between, block_mm.y), whole_blocks(between, block_mm.z)};
    walls.between_layers = whole_blocks(between, block_mm.x);
    return walls;
}

int height_of_layers(const std::vector<int>& heights, const BlockWalls& walls) {
    int sum = walls.along(0) - walls.between_layers;
    for (const int height : heights) sum += height + walls.between_layers;
    return sum;
}

bool ItemMasks::any_locked() const {
    return std::any_of(locked.begin(), locked.end(), [](bool each) { return each; });
}

Result<ItemMasks> item_masks(std::span<const Object> objects, const Design& design, Vec3d block_mm,
                             const std::vector<bool>& locked, const Progress& progress) {
    ItemMasks masks;
    masks.block_mm = block_mm;
    masks.locked = locked;
    // Places are told from the middle of the space, however many blocks it will have.
    Design settled = design;
    settled.space.wall_mm = wanted_wall_mm(design.space);
    if (!settled.space.blocks) settled.space.blocks = Vec3i{1, 1, 1};
    auto items = place_items(objects, settled);
    if (!items) return tl::unexpected(items.error());
    masks.items = std::move(*items);
    std::vector<Kind> kinds;
    std::vector<std::size_t> own(masks.items.size());
    if (auto done = add_zones(objects, design, masks); !done) return tl::unexpected(done.error());
    for (std::size_t i = 0; i < masks.items.size(); ++i)
        if (!locked[i])
            own[i] = kind_of(masks.items[i], zones_of(design.items[i], design), masks.zones[i], kinds);
    if (auto done = add_ways(objects, design, kinds, masks, progress); !done)
        return tl::unexpected(done.error());
    masks.problem.gap = block_walls(design.space, block_mm).gap;
    if (design.fit.notches) {  // one may lie between two of them
        masks.problem.gap.rows += whole_blocks(design.fit.notches->room_mm, block_mm.y);
        masks.problem.gap.columns += whole_blocks(design.fit.notches->room_mm, block_mm.z);
    }
    const std::vector<int> groups = group_numbers(masks.items, wanted_between_mm(design.space) == 0);
    const bool in_layers = design.search.layers == 1;
    for (std::size_t i = 0; i < masks.items.size(); ++i) {
        MaskPiece piece;
        piece.group = groups[i];
        piece.bin = in_layers ? masks.items[i].layer - 1 : -1;
        if (!locked[i]) piece.shapes = kinds[own[i]].shapes;
        if (!locked[i] && piece.shapes.empty())
            return fail(ErrorKind::usage, say("arrange.cuts_nothing", {{"name", masks.items[i].name}}));
        masks.problem.pieces.push_back(std::move(piece));
    }
    masks.mass = masses(masks);
    return masks;
}

Result<ItemMasks> with_locked(ItemMasks masks, std::span<const Object> objects, const DesignSpace& space,
                              const BlockWalls& walls) {
    std::vector<std::size_t> stay;
    for (std::size_t i = 0; i < masks.items.size(); ++i) {
        if (!masks.locked[i]) continue;
        const Item& item = masks.items[i];
        const Box3d room = room_of(item), box = space.box();
        const bool tray = item.rise_mm != 0;
        const auto leaves = [&](int axis) {
            return room.min[axis] < box.min[axis] - 0.01 || room.max[axis] > box.max[axis] + 0.01;
        };
        if ((!tray && leaves(0)) || leaves(1) || leaves(2))
            return fail(
                ErrorKind::does_not_fit,
                say("arrange.locked_outside", {{"name", item.name}, {"space", dimensions(space.size())}}));
        auto way = locked_way(objects[item.object], item.cut, space, item.rotation_deg, item.offset_mm,
                              masks.zones[i]);
        if (!way) return tl::unexpected(way.error());
        if (way->way.mask.rows() == 0)
            return fail(ErrorKind::usage, say("arrange.cuts_nothing", {{"name", item.name}}));
        MaskPiece& piece = masks.problem.pieces[i];
        const Vec3i first = way->first;
        piece.shapes = {add_shape(masks, std::move(way->way))};
        piece.locked = LaidMask{piece.shapes.front(), item.layer - 1, first.y - walls.side[kBack],
                                first.z - walls.side[kLeft]};
        for (const std::size_t other : stay) {
            const MaskPiece& before = masks.problem.pieces[other];
            if (before.locked->bin != piece.locked->bin) continue;
            const bool touch = piece.group >= 0 && piece.group == before.group;
            const ClashMap map(
                runs_of(masks.problem.shapes[static_cast<std::size_t>(before.shapes.front())].mask),
                runs_of(masks.problem.shapes[static_cast<std::size_t>(piece.shapes.front())].mask),
                touch ? MaskGap{} : masks.problem.gap);
            if (map.depth(piece.locked->row - before.locked->row,
                          piece.locked->column - before.locked->column) > 0)
                return tl::unexpected(locked_meet(masks.items[other], item,
                                                  touch ? 0 : masks.problem.gap.columns * masks.block_mm.z));
        }
        stay.push_back(i);
    }
    return masks;
}

int LayerLevels::first_of(int item_height) const {
    const int room = std::max(0, height - item_height);
    if (!parting) return first + room / 2;
    return std::clamp(*parting - (item_height + 1) / 2, first, first + room);
}

std::vector<LayerLevels> layer_levels(const std::vector<int>& heights, const BlockWalls& walls) {
    std::vector<LayerLevels> levels;
    int at = walls.side[kFloor];
    for (const int height : heights) {
        levels.push_back({at, height, {}});
        at += height + walls.between_layers;
    }
    return levels;
}

void take_layout(const ItemMasks& masks, const MaskLayout& layout, const std::vector<LayerLevels>& levels,
                 const DesignSpace& space, const BlockWalls& walls, Design& design) {
    for (std::size_t i = 0; i < layout.size(); ++i) {
        if (masks.locked[i]) continue;
        const LaidMask& at = layout[i];
        const ItemWay& way = masks.ways[static_cast<std::size_t>(at.shape)];
        const LayerLevels& level = levels[static_cast<std::size_t>(at.bin)];
        const Vec3d corner{space.face(0, level.first_of(way.height)),
                           space.face(1, walls.side[kBack] + at.row),
                           space.face(2, walls.side[kLeft] + at.column)};
        const Vec3d offset = corner + way.offset_mm;
        ItemOptions& item = design.items[i];
        item.rotation_deg = way.rotation_deg;
        item.offset_mm = Vec3d{design.space.open ? 0 : tidy(offset.x), tidy(offset.y), tidy(offset.z)};
        item.layer = at.bin + 1;
    }
}

}  // namespace snug
