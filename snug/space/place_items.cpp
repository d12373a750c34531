#include "snug/space/place_items.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "snug/space/fitted_space.h"
#include "snug/space/place_object.h"
#include "snug/space/place_zones.h"
#include "snug/space/space_for.h"
#include "snug/space/tray.h"

namespace snug {
namespace {

Result<Item> placed(std::span<const Object> objects, const ItemOptions& options, const Design& design,
                    Vec3d walls_shift, const Progress& progress) {
    const auto index = static_cast<std::size_t>(options.object);
    if (index >= objects.size())
        return fail(ErrorKind::usage, say("items.no_object", {{"number", std::to_string(options.object)},
                                                              {"objects", objects.size()}}));
    Item item{index,
              options.name.empty() ? objects[index].name : options.name,
              options.group,
              options.layer,
              options.rotation_deg.value_or(design.placement.rotation_deg),
              options.offset_mm.value_or(design.placement.offset_mm),
              cut_of(options, design),
              mass_kg(options, design),
              {},
              {}};
    const auto placement =
        place(objects[index], item.rotation_deg, item.offset_mm + walls_shift, part_of(progress, 0, 0.5));
    if (!placement) return tl::unexpected(placement.error());
    item.placement = *placement;
    auto zones =
        place_zones(objects[index], zones_of(options, design), item.placement, part_of(progress, 0.5, 1));
    if (!zones) return tl::unexpected(zones.error());
    item.zones = std::move(*zones);
    return item;
}

constexpr double kPastFace = 0.01;  // mm: no longer touching

/// Between two grown boxes lies a block more than what is wanted, so that as many whole blocks lie between
/// them wherever the lattice is; also where both end on its lines and cut what they touch. mm.
double apart_along(int axis, const Design& design) {
    const double block = design.space.block_mm[axis];
    return (std::ceil(wanted_between_mm(design.space) / block - 1e-9) + 1) * block +
           (design.cut.cut_on_touch ? kPastFace : 0);
}

/// One after the other along z, their middle at `middle`.
void stand_in_a_row(const std::vector<Item*>& row, const Design& design, double middle) {
    const double apart = apart_along(2, design);
    double length = -apart;
    for (const Item* item : row) length += room_of(*item).size().z + apart;
    double at = middle - length / 2;
    for (Item* item : row) {
        const Box3d room = room_of(*item);
        move(*item, {0, 0, at - room.min.z});
        at += room.size().z + apart;
    }
}

double volume(Vec3d size) {
    return size.x * size.y * size.z;
}

/// Of one layer, the largest first.
std::vector<Item*> without_a_place(std::vector<Item>& items, const Design& design, int layer) {
    std::vector<Item*> row;
    for (std::size_t i = 0; i < items.size(); ++i)
        if (!design.items[i].offset_mm && items[i].layer == layer) row.push_back(&items[i]);
    std::stable_sort(row.begin(), row.end(), [](const Item* a, const Item* b) {
        return volume(a->placement.bounds.size()) > volume(b->placement.bounds.size());
    });
    return row;
}

Box3d room_of(const std::vector<Item*>& items) {
    Box3d room;
    for (const Item* item : items) room.include(room_of(*item));
    return room;
}

/// Layers of items upon each other, their middle at `middle`.
void stack(const std::vector<std::vector<Item*>>& layers, const Design& design, double middle) {
    const double apart = apart_along(0, design);
    double height = -apart;
    for (const auto& layer : layers)
        if (!layer.empty()) height += room_of(layer).size().x + apart;
    double at = middle - height / 2;
    for (const auto& layer : layers) {
        if (layer.empty()) continue;
        const Box3d room = room_of(layer);
        for (Item* item : layer) move(*item, {at - room.min.x, 0, 0});
        at += room.size().x + apart;
    }
}

/// Rows along z, a row for each layer.
void place_beside_each_other(std::vector<Item>& items, const Design& design, Vec3d middle) {
    std::vector<std::vector<Item*>> layers;
    for (int layer = 1; layer <= layers_of(design); ++layer) {
        layers.push_back(without_a_place(items, design, layer));
        stand_in_a_row(layers.back(), design, middle.z);
    }
    if (layers.size() > 1 && !design.space.open) stack(layers, design, middle.x);
}

/// Shifts all so that what they take up together is centred, as a single object is.
void centre(std::vector<Item>& items, Vec3d middle, bool along_x) {
    Vec3d by = middle - room_of(items).centre();
    if (!along_x) by.x = 0;
    for (Item& item : items) move(item, by);
}

/// The design's own blocks or those of its case.
Result<DesignSpace> given_space(const Design& design) {
    if (!design.case_options.inside_mm) return DesignSpace{*design.space.blocks, design.space.block_mm};
    const auto fitted = case_space(design);
    if (!fitted) return tl::unexpected(fitted.error());
    return fitted->space;
}

/// Along x: in the middle of a space that is fitted to the items, or on the floor of one that is given.
Result<void> lay_in_tray(std::vector<Item>& items, const Design& design, double middle, bool fitted) {
    settle_in_tray(items, *design.space.open, apart_along(0, design));
    double rise = middle - room_of(items).centre().x;
    if (!fitted) {
        const auto space = given_space(design);
        if (!space) return tl::unexpected(space.error());
        rise = rise_to_floor(items, space->face(0, 0), wanted_wall_mm(design.space)[0], space->block_mm.x);
    }
    for (Item& item : items) raise(item, rise);
    return {};
}

/// Findings must tell items of one name apart: by their numbers, as the report has them.
void number_equal_names(std::vector<Item>& items) {
    std::map<std::string, int> count;
    for (const Item& item : items) ++count[item.name];
    for (std::size_t i = 0; i < items.size(); ++i)
        if (count[items[i].name] > 1) items[i].name += " (" + std::to_string(i + 1) + ")";
}

}  // namespace

Result<std::vector<Item>> place_items(std::span<const Object> objects, const Design& design,
                                      const Progress& progress) {
    const bool in_case = design.case_options.inside_mm.has_value();
    const Vec3d walls = shift_between_walls(design.space, in_case);
    std::vector<Item> items;
    const auto share = 1 / static_cast<double>(design.items.size());
    for (const ItemOptions& options : design.items) {
        const double done = share * static_cast<double>(items.size());
        auto item = placed(objects, options, design, walls, part_of(progress, done, done + share));
        if (!item) return tl::unexpected(item.error());
        items.push_back(std::move(*item));
    }
    const bool fitted = !design.space.blocks && !in_case;
    if (items.size() > 1) {
        number_equal_names(items);
        place_beside_each_other(items, design, design.placement.offset_mm + walls);
        if (fitted) centre(items, walls, !design.space.open);
    }
    if (design.space.open)
        if (auto done = lay_in_tray(items, design, walls.x, fitted); !done)
            return tl::unexpected(done.error());
    return items;
}

}  // namespace snug
