#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include "snug/search/arranger.h"
#include "snug/search/layer_heights.h"
#include "snug/space/available.h"

// The smallest space around items that stay where they are, which is counted from its middle: how they meet
// its blocks depends on how many there are.

namespace snug {
namespace {

/// The fewest blocks along an axis that leave the walls between what is locked and both ends. A hundredth of
/// a millimetre may lie in the next block (depth_map.h).
int blocks_around(const Box3d& stay, int axis, const BlockWalls& walls, double block_mm) {
    const auto side = static_cast<std::size_t>(2 * axis);
    const double half = std::max(walls.side[side] + (-stay.min[axis] - 0.01) / block_mm,
                                 walls.side[side + 1] + (stay.max[axis] - 0.01) / block_mm);
    return std::max(1, static_cast<int>(std::ceil(2 * half - 1e-9)));
}

bool locked_keep_walls(const ItemMasks& masks, const MaskRoom& room) {
    return std::all_of(masks.problem.pieces.begin(), masks.problem.pieces.end(), [&](const MaskPiece& piece) {
        if (!piece.locked) return true;
        const LaidMask& at = *piece.locked;
        const BitMask& mask = masks.problem.shapes[static_cast<std::size_t>(at.shape)].mask;
        return at.row >= 0 && at.column >= 0 && at.row + mask.rows() <= room.rows &&
               at.column + mask.columns() <= room.columns;
    });
}

/// What the items that are free take at least.
long long free_columns(const MaskProblem& problem) {
    long long sum = 0;
    for (const MaskPiece& piece : problem.pieces) {
        long long least = 0;
        for (const int shape : piece.shapes) {
            const long long own = problem.shapes[static_cast<std::size_t>(shape)].mask.count();
            least = least == 0 ? own : std::min(least, own);
        }
        sum += least;
    }
    return sum;
}

}  // namespace

std::vector<Vec3i> Arranger::spaces_around_locked(const std::vector<int>& heights) const {
    const BlockWalls walls = block_walls(design_.space, masks_->block_mm);
    Box3d stay;
    for (std::size_t i = 0; i < masks_->items.size(); ++i)
        if (locked_[i]) stay.include(room_of(masks_->items[i]));
    Vec3i least;
    for (int axis = 0; axis < 3; ++axis)
        least[axis] =
            std::max(blocks_around(stay, axis, walls, masks_->block_mm[axis]), walls.along(axis) + 1);
    const int high = height_of_layers(heights, walls);
    least.x = design_.space.open ? high : std::max(least.x, high);
    const RoomTask task = task_for(heights);
    const long long free = free_columns(masks_->problem), layers = static_cast<long long>(heights.size());
    std::vector<std::pair<long long, Vec3i>> priced;
    // What lies beside something locked widens both sides, since that stays in the middle.
    for (int y = least.y; y <= std::min(kMostBlocks, least.y + 2 * task.most_rows); ++y)
        for (int z = least.z; z <= std::min(kMostBlocks, least.z + 2 * task.most_columns); ++z)
            if (layers * (y - walls.along(1)) * (z - walls.along(2)) >= free)
                priced.push_back({space_price({least.x, y, z}, design_, masks_->block_mm), {least.x, y, z}});
    std::sort(priced.begin(), priced.end(), [](const auto& a, const auto& b) {
        return std::tuple(a.first, a.second.y) < std::tuple(b.first, b.second.y);
    });
    std::vector<Vec3i> spaces;
    for (const auto& [price, blocks] : priced) spaces.push_back(blocks);
    return spaces;
}

Result<Arranger::Found> Arranger::around_locked() {
    constexpr int kTries = 50;  // of the work is what each space is looked at
    const BlockWalls walls = block_walls(design_.space, masks_->block_mm);
    const auto choices = all_heights(kMostBlocks);
    const std::vector<int> heights = choices.empty() ? std::vector<int>{1} : choices.front();
    for (const Vec3i blocks : spaces_around_locked(heights)) {
        const DesignSpace space{blocks, masks_->block_mm};
        auto masks = with_locked(*masks_, objects_, space, walls);
        if (!masks) return tl::unexpected(masks.error());
        std::vector<int> inner = heights;
        inner.back() += std::max(0, blocks.x - height_of_layers(heights, walls));
        const GivenRoom given = given_room({space, {}, all_blocks(blocks)}, *masks, design_, inner);
        if (!locked_keep_walls(*masks, given.room)) continue;
        MaskPacker packer(masks->problem, design_.search.seed, packing_watch());
        auto found = in_room(*masks, given, packer, std::min(work_, usual_arranging_work(design_)) / kTries);
        done_ += packer.work();
        if (cancelled_) return fail(ErrorKind::cancelled, say("cancelled"));
        if (!found) continue;
        found->heights = inner;
        tell(*masks, *found);
        settle(*masks, *found, packer);
        masks_ = std::move(*masks);
        return *found;
    }
    return fail(ErrorKind::does_not_fit, say("arrange.none_around_locked"));
}

}  // namespace snug
