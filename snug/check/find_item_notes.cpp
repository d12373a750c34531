#include "snug/check/find_item_notes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "snug/base/text.h"

namespace snug {
namespace {

constexpr std::size_t kMostNotes = 6;  // of a kind
constexpr double kAlike = 5;           // mm that boxes may differ along each axis and be mixed up

bool over_each_other(const Box3d& a, const Box3d& b) {
    return a.min.y < b.max.y && b.min.y < a.max.y && a.min.z < b.max.z && b.min.z < a.max.z;
}

/// The lightest item in a lower layer right below this one that is lighter than it.
const Item* crushed_by(const Item& heavy, const std::vector<Item>& items) {
    const Item* lightest = nullptr;
    for (const Item& item : items) {
        if (item.layer >= heavy.layer || !item.mass_kg || *item.mass_kg >= *heavy.mass_kg) continue;
        if (!over_each_other(heavy.placement.bounds, item.placement.bounds)) continue;
        if (!lightest || *item.mass_kg < *lightest->mass_kg) lightest = &item;
    }
    return lightest;
}

/// As they lie, or one of them turned by a quarter.
bool alike(const Item& a, const Item& b) {
    const Vec3d one = a.placement.bounds.size(), other = b.placement.bounds.size();
    const auto near = [](double x, double y) { return std::fabs(x - y) <= kAlike; };
    return near(one.x, other.x) &&
           ((near(one.y, other.y) && near(one.z, other.z)) || (near(one.y, other.z) && near(one.z, other.y)));
}

}  // namespace

void find_item_notes(const std::vector<Item>& items, std::vector<Finding>& findings) {
    std::size_t heavy = 0, mixed = 0;
    for (const Item& item : items) {
        const Item* const below = item.mass_kg ? crushed_by(item, items) : nullptr;
        if (!below || ++heavy > kMostNotes) continue;
        findings.push_back({Severity::note,
                            say("heavy_above", {{"one", item.name},
                                                {"kg", number(*item.mass_kg, 3)},
                                                {"other", below->name},
                                                {"lighter_kg", number(*below->mass_kg, 3)}}),
                            item.placement.bounds.centre()});
    }
    for (std::size_t a = 0; a < items.size(); ++a)
        for (std::size_t b = a + 1; b < items.size(); ++b) {
            if (items[a].object == items[b].object || !alike(items[a], items[b]) || ++mixed > kMostNotes)
                continue;
            findings.push_back({Severity::note,
                                say("mixed_up", {{"one", items[a].name}, {"other", items[b].name}}),
                                items[a].placement.bounds.centre()});
        }
}

}  // namespace snug
