#include "snug/space/spread_items.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <string>

#include "snug/base/box.h"

namespace snug {
namespace {

/// What goes together, and what each takes up.
struct Units {
    std::vector<std::size_t> of_item;
    std::vector<Box3d> rooms;
};

Units units_of(const std::vector<Item>& items) {
    Units units;
    std::map<std::string, std::size_t> groups;
    for (const Item& item : items) {
        std::size_t unit = units.rooms.size();
        if (!item.group.empty()) unit = groups.try_emplace(item.group, unit).first->second;
        if (unit == units.rooms.size()) units.rooms.emplace_back();
        units.rooms[unit].include(room_of(item));
        units.of_item.push_back(unit);
    }
    return units;
}

bool overlap_across(int axis, const Box3d& a, const Box3d& b) {
    for (int other = 0; other < 3; ++other)
        if (other != axis && !(a.min[other] < b.max[other] && b.min[other] < a.max[other])) return false;
    return true;
}

/// How many stand in the longest row before each, along an axis.
std::vector<int> places_in_rows(int axis, const std::vector<Box3d>& rooms) {
    std::vector<std::size_t> order(rooms.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return rooms[a].centre()[axis] < rooms[b].centre()[axis];
    });
    std::vector<int> places(rooms.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (overlap_across(axis, rooms[order[i]], rooms[order[k]]))
                places[order[i]] = std::max(places[order[i]], places[order[k]] + 1);
    return places;
}

}  // namespace

std::vector<Vec3d> shifts_apart(const std::vector<Item>& items, Vec3d more_mm) {
    Units units = units_of(items);
    std::vector<Vec3d> unit_shifts(units.rooms.size());
    for (const int axis : {1, 2}) {
        const std::vector<int> places = places_in_rows(axis, units.rooms);
        for (std::size_t i = 0; i < places.size(); ++i) {
            Vec3d shift;
            shift[axis] = places[i] * more_mm[axis];
            unit_shifts[i] = unit_shifts[i] + shift;
            units.rooms[i] = {units.rooms[i].min + shift, units.rooms[i].max + shift};
        }
    }
    std::vector<Vec3d> shifts;
    for (const std::size_t unit : units.of_item) shifts.push_back(unit_shifts[unit]);
    return shifts;
}

}  // namespace snug
