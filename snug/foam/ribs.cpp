#include "snug/foam/ribs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "snug/base/grid.h"
#include "snug/base/sliding.h"

namespace snug {
namespace {

using Heights = Grid<std::uint16_t>;
constexpr std::uint16_t kCase = std::numeric_limits<std::uint16_t>::max();

/// Along z; `around`: cells of the case that are put before and after each line.
template <class Choose>
Heights slid(const Heights& heights, int window, int around, Choose choose) {
    Heights result(heights.ny(), heights.nz() + 2 * around - (window - 1));
    std::vector<std::uint16_t> line;
    for (int j = 0; j < heights.ny(); ++j) {
        line.assign(static_cast<std::size_t>(around), kCase);
        for (int k = 0; k < heights.nz(); ++k) line.push_back(heights(j, k));
        line.insert(line.end(), static_cast<std::size_t>(around), kCase);
        slide(line, static_cast<std::size_t>(window), choose);
        for (int k = 0; k < result.nz(); ++k) result(j, k) = line[static_cast<std::size_t>(k)];
    }
    return result;
}

Heights turned(const Heights& heights) {
    Heights result(heights.nz(), heights.ny());
    for (int j = 0; j < heights.ny(); ++j)
        for (int k = 0; k < heights.nz(); ++k) result(k, j) = heights(j, k);
    return result;
}

/// The opening by a rectangle of wy x wz columns (erosion, then dilation): under the heights, all that the
/// rectangle reaches.
Heights opening(const Heights& heights, int wy, int wz) {
    const auto least = [](std::uint16_t a, std::uint16_t b) { return std::min(a, b); };
    const auto most = [](std::uint16_t a, std::uint16_t b) { return std::max(a, b); };
    Heights eroded = turned(slid(heights, wz, wz - 1, least));
    eroded = slid(eroded, wy, wy - 1, least);
    return slid(turned(slid(eroded, wy, 0, most)), wz, 0, most);
}

int columns(double least_mm, double block_mm) {
    return std::max(1, static_cast<int>(std::ceil(std::min(least_mm / block_mm, 1e6) - 1e-9)));
}

}  // namespace

long long cut_thin_ribs(BlockMap& blocks, const DesignSpace& space, int parting_level, double least_mm) {
    // More than the space is wide says no more than its width.
    const int wy = std::min(columns(least_mm, space.block_mm.y), space.blocks.y);
    const int wz = std::min(columns(least_mm, space.block_mm.z), space.blocks.z);
    if (wy == 1 && wz == 1) return 0;
    const int nx = space.blocks.x;
    Heights lower(blocks.ny(), blocks.nz()), upper(blocks.ny(), blocks.nz());
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const CutRun run = blocks[i];
        lower[i] = static_cast<std::uint16_t>(run.none() ? parting_level : run.first);
        upper[i] = static_cast<std::uint16_t>(nx - (run.none() ? parting_level : run.end));
    }
    lower = opening(lower, wy, wz);
    upper = opening(upper, wy, wz);
    long long cut = 0;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const CutRun before = blocks[i];
        const CutRun after{static_cast<std::int16_t>(lower[i]), static_cast<std::int16_t>(nx - upper[i])};
        cut += after.blocks() - before.blocks();
        if (!after.none()) blocks[i] = after;
    }
    return cut;
}

}  // namespace snug
