#include "snug/foam/fit_report.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace snug {
namespace {

std::array<double, 6> walls(const BlockMap& blocks, const DesignSpace& space) {
    const Vec3i n = space.blocks;
    std::array<int, 6> thinnest{n.x, n.x, n.y, n.y, n.z, n.z};
    const auto at_most = [&](Side side, int count) { thinnest[side] = std::min(thinnest[side], count); };
    for (int j = 0; j < n.y; ++j) {
        for (int k = 0; k < n.z; ++k) {
            const CutRun run = blocks(j, k);
            if (run.none()) continue;
            at_most(kFloor, run.first);
            at_most(kRoof, n.x - run.end);
            at_most(kBack, j);
            at_most(kFront, n.y - 1 - j);
            at_most(kLeft, k);
            at_most(kRight, n.z - 1 - k);
        }
    }
    std::array<double, 6> mm{};
    for (std::size_t side = 0; side < 6; ++side)
        mm[side] = thinnest[side] * space.block_mm[static_cast<int>(side) / 2];
    return mm;
}

/// Columns of a height field all stand on the same plane, so pieces are connected areas of non-empty columns.
int pieces(const Grid<std::uint16_t>& heights) {
    Grid<std::uint8_t> seen(heights.ny(), heights.nz());
    std::vector<std::pair<int, int>> open;
    int count = 0;
    const auto visit = [&](int j, int k) {
        if (!heights.contains(j, k) || heights(j, k) == 0 || seen(j, k)) return;
        seen(j, k) = 1;
        open.emplace_back(j, k);
    };
    for (int j = 0; j < heights.ny(); ++j) {
        for (int k = 0; k < heights.nz(); ++k) {
            visit(j, k);
            if (open.empty()) continue;
            ++count;
            while (!open.empty()) {
                const auto [row, column] = open.back();
                open.pop_back();
                visit(row - 1, column);
                visit(row + 1, column);
                visit(row, column - 1);
                visit(row, column + 1);
            }
        }
    }
    return count;
}

}  // namespace

FitReport fit_report(const FoamPair& foams, const BlockMap& blocks, const DesignSpace& space) {
    FitReport report;
    for (const auto height : foams.lower) report.lower_blocks += height;
    for (const auto height : foams.upper) report.upper_blocks += height;
    for (const CutRun run : blocks) report.cut_blocks += run.blocks();
    report.foam_mm3 = static_cast<double>(report.lower_blocks + report.upper_blocks) * space.block_volume();
    report.fill_ratio = static_cast<double>(report.lower_blocks + report.upper_blocks) /
                        static_cast<double>(space.block_count());
    report.wall_mm = walls(blocks, space);
    report.lower_pieces = pieces(foams.lower);
    report.upper_pieces = pieces(foams.upper);
    return report;
}

}  // namespace snug
