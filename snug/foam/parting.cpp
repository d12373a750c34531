#include "snug/foam/parting.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>
#include <vector>

namespace snug {
namespace {

struct LevelRange {
    int lowest;
    int highest;
};

LevelRange cut_range(const BlockMap& blocks, int nx) {
    LevelRange range{nx, 0};
    for (const CutRun run : blocks) {
        if (run.none()) continue;
        range.lowest = std::min<int>(range.lowest, run.first);
        range.highest = std::max<int>(range.highest, run.end);
    }
    return range;
}

/// Steps against the parting level, counted in blocks for every level at once: sides between two columns that
/// the object cuts step the same whatever the level is, and sides between two free columns never step.
/// Integers, so that equal areas compare as equal.
std::vector<long long> steps_by_level(const BlockMap& blocks, int nx, bool along_y) {
    std::vector<long long> meeting(static_cast<std::size_t>(nx) + 1);
    for_each_side(blocks, [&](int j, int k, int j2, int k2, bool side_along_y) {
        if (side_along_y != along_y || blocks(j, k).none() == blocks(j2, k2).none()) return;
        const CutRun run = blocks(j, k).none() ? blocks(j2, k2) : blocks(j, k);
        ++meeting[static_cast<std::size_t>(run.first)];
        ++meeting[static_cast<std::size_t>(run.end)];
    });
    std::vector<long long> steps(meeting.size());
    long long sum = 0, below = 0, all = 0;
    for (std::size_t level = 0; level < meeting.size(); ++level) {
        sum += meeting[level] * static_cast<long long>(level);
        all += meeting[level];
    }
    for (std::size_t level = 0; level < meeting.size(); ++level) {
        steps[level] = sum;
        below += meeting[level];
        sum += 2 * below - all;
    }
    return steps;
}

}  // namespace

double stepped_wall_area(const BlockMap& blocks, const DesignSpace& space, int level) {
    const int nx = space.blocks.x;
    const auto lower = [&](CutRun run) { return run.none() ? level : run.first; };
    const auto upper = [&](CutRun run) { return nx - (run.none() ? level : run.end); };
    long long along_y = 0, along_z = 0;
    for_each_side(blocks, [&](int j, int k, int j2, int k2, bool side_along_y) {
        const CutRun a = blocks(j, k), b = blocks(j2, k2);
        (side_along_y ? along_y : along_z) += std::abs(lower(a) - lower(b)) + std::abs(upper(a) - upper(b));
    });
    const Vec3d block = space.block_mm;
    return block.x * (block.z * static_cast<double>(along_y) + block.y * static_cast<double>(along_z));
}

int auto_parting_level(const BlockMap& blocks, const DesignSpace& space, const Box3d& object) {
    const int nx = space.blocks.x;
    const LevelRange range = cut_range(blocks, nx);
    if (range.lowest > range.highest) return nx / 2;

    const auto along_y = steps_by_level(blocks, nx, true);
    const auto along_z = steps_by_level(blocks, nx, false);
    const auto area = [&](int level) {
        const auto i = static_cast<std::size_t>(level);
        return space.block_mm.z * static_cast<double>(along_y[i]) +
               space.block_mm.y * static_cast<double>(along_z[i]);
    };
    double least = area(range.lowest);
    for (int level = range.lowest; level <= range.highest; ++level) least = std::min(least, area(level));

    const double middle = object.centre().x;
    const auto preference = [&](int level) {
        const bool slips = level <= range.lowest;
        return std::tuple(slips, std::fabs(space.face(0, level) - middle), -level);
    };
    int best = -1;
    for (int level = range.lowest; level <= range.highest; ++level) {
        if (area(level) > least * (1 + 1e-12)) continue;
        if (best < 0 || preference(level) < preference(best)) best = level;
    }
    return best;
}

}  // namespace snug
