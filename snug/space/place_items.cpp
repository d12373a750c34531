#include "snug/space/place_items.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "snug/space/fitted_space.h"
#include "snug/space/place_object.h"

namespace snug {
namespace {

void move(Item& item, Vec3d by) {
    item.offset_mm = item.offset_mm + by;
    item.placement.shift = item.placement.shift + by;
    item.placement.bounds = {item.placement.bounds.min + by, item.placement.bounds.max + by};
}

Result<Item> placed(std::span<const Object> objects, const ItemOptions& options, const Design& design,
                    Vec3d walls_shift, const Progress& progress) {
    const auto index = static_cast<std::size_t>(options.object);
    if (index >= objects.size())
        return fail(ErrorKind::usage, say("items.no_object", {{"number", std::to_string(options.object)},
                                                              {"objects", objects.size()}}));
    Item item{index,
              options.name.empty() ? objects[index].name : options.name,
              options.group,
              options.rotation_deg.value_or(design.placement.rotation_deg),
              options.offset_mm.value_or(design.placement.offset_mm),
              cut_of(options, design),
              mass_kg(options, design),
              {}};
    const auto placement = place(objects[index], item.rotation_deg, item.offset_mm + walls_shift, progress);
    if (!placement) return tl::unexpected(placement.error());
    item.placement = *placement;
    return item;
}

/// One after the other along z, their middle at `middle`. Between two grown boxes lies a block more than what
/// is wanted, so that as many whole blocks lie between them wherever the lattice is.
void stand_in_a_row(const std::vector<Item*>& row, const SpaceOptions& space, double middle) {
    const double block = space.block_mm.z;
    const double apart = (std::ceil(wanted_between_mm(space) / block - 1e-9) + 1) * block;
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

std::vector<Item*> without_a_place(std::vector<Item>& items, const Design& design) {
    std::vector<Item*> row;
    for (std::size_t i = 0; i < items.size(); ++i)
        if (!design.items[i].offset_mm) row.push_back(&items[i]);
    std::stable_sort(row.begin(), row.end(), [](const Item* a, const Item* b) {
        return volume(a->placement.bounds.size()) > volume(b->placement.bounds.size());
    });
    return row;
}

/// Shifts all so that what they take up together is centred, as a single object is.
void centre(std::vector<Item>& items, Vec3d middle) {
    const Vec3d by = middle - room_of(items).centre();
    for (Item& item : items) move(item, by);
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
    if (items.size() == 1) return items;
    number_equal_names(items);
    stand_in_a_row(without_a_place(items, design), design.space, design.placement.offset_mm.z + walls.z);
    if (!design.space.blocks && !in_case) centre(items, walls);
    return items;
}

}  // namespace snug
