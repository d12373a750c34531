#include "snug/search/other_arrangements.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "snug/search/arranger.h"
#include "snug/search/arranging.h"

namespace snug {
namespace {

constexpr double kMostVolume = 1.5;  // of the best one's
constexpr int kLessOf5 = 4;          // of five blocks along a side so many
constexpr int kMostOtherLayers = 4;
constexpr long long kOthers = 4;  // that are looked for: what each may take of the work

bool chose_layers(const Design& start) {
    return start.search.layers.value_or(1) != 1 || layers_of(start) != 1;
}

Design with_layers(Design design, int layers) {
    design.search.layers = layers;
    return design;
}

double volume_of(const Design& design) {
    if (!design.space.blocks) return 0;
    const Vec3i blocks = *design.space.blocks;
    return static_cast<double>(blocks.x) * blocks.y * blocks.z;
}

/// Spaces that could stand in each other's place, with as many layers.
bool alike(const Design& a, const Design& b) {
    if (layers_of(a) != layers_of(b)) return false;
    if (!a.space.blocks || !b.space.blocks) return true;
    const Vec3i one = *a.space.blocks, other = *b.space.blocks;
    return one.x == other.x && std::minmax(one.y, one.z) == std::minmax(other.y, other.z);
}

}  // namespace

std::vector<ArrangedDesign> other_arrangements(std::span<Object> objects, const Design& start,
                                               const Design& best, long long work,
                                               const ArrangeWatch& watch) {
    std::vector<ArrangedDesign> others;
    const std::vector<bool> locked = locked_items(start, true);
    if (std::find(locked.begin(), locked.end(), true) != locked.end()) return others;
    if (!begin_arranging(objects, start, watch)) return others;
    const ArrangeWatch quiet{watch.go_on, {}, watch.pack_it};
    const auto take = [&](const Result<Arrangement>& found, Design design) {
        if (!found || found->cancelled || volume_of(design) > kMostVolume * volume_of(best)) return;
        if (alike(design, best)) return;
        for (ArrangedDesign& other : others) {
            if (!alike(design, other.design)) continue;
            if (found->volume_mm3 < other.arrangement.volume_mm3) other = {std::move(design), *found};
            return;
        }
        others.push_back({std::move(design), *found});
    };
    if (!has_given_space(start) && best.space.blocks)
        for (const int axis : {1, 2}) {
            Vec3i most{kMostBlocks, kMostBlocks, kMostBlocks};
            (axis == 1 ? most.y : most.z) = (*best.space.blocks)[axis] * kLessOf5 / 5;
            Design design = start;
            Arranger arranger(objects, start, locked, work / kOthers, quiet);
            arranger.keep_below(most);
            const auto found = arranger.run(design, false);
            take(found, std::move(design));
        }
    if (!chose_layers(start))
        for (const int layers : {layers_of(best) + 1, layers_of(best) - 1}) {
            if (layers < 1 || layers > std::min<int>(kMostOtherLayers, static_cast<int>(start.items.size())))
                continue;
            Design design = with_layers(start, layers);
            const auto found = arranged(objects, design, locked, work / kOthers, quiet, false);
            design.search.layers = start.search.layers;
            take(found, std::move(design));
        }
    std::stable_sort(others.begin(), others.end(), [](const ArrangedDesign& a, const ArrangedDesign& b) {
        return a.arrangement.volume_mm3 < b.arrangement.volume_mm3;
    });
    return others;
}

}  // namespace snug
