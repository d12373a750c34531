#include "snug/foam/object_cut.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "snug/foam/parting.h"

namespace snug {
namespace {

CutRun either(CutRun a, CutRun b) {
    if (a.none()) return b;
    if (b.none()) return a;
    return {std::min(a.first, b.first), std::max(a.end, b.end)};
}

CutRun both(CutRun lower, CutRun upper, std::int16_t level) {
    const CutRun own{lower.none() ? level : lower.first, upper.none() ? level : upper.end};
    if (!own.none()) return own;
    const CutRun parted{std::min(own.first, level), std::max(own.end, level)};
    return parted.none() ? CutRun{} : parted;
}

void include(BlockMap& blocks, const BlockMap& more) {
    for (std::size_t i = 0; i < blocks.size(); ++i) blocks[i] = either(blocks[i], more[i]);
}

}  // namespace

HalfCuts half_cuts(const ObjectDepths& depths, const DesignSpace& space) {
    HalfCuts cuts{block_map(depths.lower.depths, space, depths.lower.reach), {}};
    if (depths.upper) cuts.upper = block_map(depths.upper->depths, space, depths.upper->reach);
    return cuts;
}

BlockMap cut_by_either(const HalfCuts& cuts) {
    BlockMap blocks = cuts.lower;
    if (cuts.upper) include(blocks, *cuts.upper);
    return blocks;
}

HalfCuts united(std::span<const HalfCuts* const> items) {
    HalfCuts all = *items.front();
    const bool differ =
        std::any_of(items.begin(), items.end(), [](const HalfCuts* each) { return each->upper.has_value(); });
    if (differ && !all.upper) all.upper = all.lower;
    for (const HalfCuts* each : items.subspan(1)) {
        include(all.lower, each->lower);
        if (differ) include(*all.upper, each->upper ? *each->upper : each->lower);
    }
    return all;
}

BlockMap cut_by_both(const HalfCuts& cuts, int parting_level) {
    BlockMap blocks = cuts.lower;
    if (cuts.upper)
        for (std::size_t i = 0; i < blocks.size(); ++i)
            blocks[i] = both(blocks[i], (*cuts.upper)[i], static_cast<std::int16_t>(parting_level));
    return blocks;
}

BlockMap object_cut(const HalfCuts& cuts, const DesignSpace& space, const Box3d& placed) {
    if (!cuts.upper) return cuts.lower;
    return cut_by_both(cuts, auto_parting_level(cut_by_either(cuts), space, placed));
}

}  // namespace snug
