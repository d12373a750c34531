#include "snug/foam/fit_report.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace snug {
namespace {

std::array<int, 6> thinnest_of(const BlockMap& blocks, Vec3i n) {
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
    return thinnest;
}

/// How many blocks lie between a cut block and the end of those that exist, going by (dj, dk).
int blocks_to_case(const Available& available, int level, int j, int k, int dj, int dk) {
    int count = -1;
    for (; available.contains(j, k); j += dj, k += dk, ++count)
        if (level < available(j, k).first || level >= available(j, k).end) break;
    return std::max(0, count);
}

/// The same within a case that shortens columns. It is convex, so its walls are nearest to the ends of a run.
std::array<int, 6> thinnest_within(const Available& available, const BlockMap& blocks, Vec3i n) {
    std::array<int, 6> thinnest{n.x, n.x, n.y, n.y, n.z, n.z};
    const auto at_most = [&](Side side, int count) { thinnest[side] = std::min(thinnest[side], count); };
    for (int j = 0; j < n.y; ++j) {
        for (int k = 0; k < n.z; ++k) {
            const CutRun run = blocks(j, k);
            if (run.none()) continue;
            at_most(kFloor, std::max(0, run.first - available(j, k).first));
            at_most(kRoof, std::max(0, available(j, k).end - run.end));
            for (const int level : {run.first + 0, run.end - 1}) {
                at_most(kBack, blocks_to_case(available, level, j, k, -1, 0));
                at_most(kFront, blocks_to_case(available, level, j, k, 1, 0));
                at_most(kLeft, blocks_to_case(available, level, j, k, 0, -1));
                at_most(kRight, blocks_to_case(available, level, j, k, 0, 1));
            }
        }
    }
    return thinnest;
}

std::array<double, 6> in_millimetres(const std::array<int, 6>& thinnest, const DesignSpace& space) {
    std::array<double, 6> mm{};
    for (std::size_t side = 0; side < 6; ++side)
        mm[side] = thinnest[side] * space.block_mm[static_cast<int>(side) / 2];
    return mm;
}

/// Pieces are connected areas of non-empty columns: those of a height field all stand on the same plane, and
/// where a case shortens them neighbours hang together if some level is in both.
class PieceCounter {
  public:
    PieceCounter(const Grid<std::uint16_t>& heights, const Grid<std::uint16_t>& missing)
        : heights_(heights), missing_(missing), seen_(heights.ny(), heights.nz()) {}

    int count() {
        int pieces = 0;
        for (int j = 0; j < heights_.ny(); ++j) {
            for (int k = 0; k < heights_.nz(); ++k) {
                if (heights_(j, k) == 0 || seen_(j, k)) continue;
                ++pieces;
                mark_piece(j, k);
            }
        }
        return pieces;
    }

  private:
    void mark_piece(int j, int k) {
        seen_(j, k) = 1;
        open_.emplace_back(j, k);
        while (!open_.empty()) {
            const auto [row, column] = open_.back();
            open_.pop_back();
            for (const auto& [dj, dk] :
                 {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)})
                visit(row, column, row + dj, column + dk);
        }
    }

    void visit(int from_j, int from_k, int j, int k) {
        if (!heights_.contains(j, k) || heights_(j, k) == 0 || seen_(j, k)) return;
        if (bottom(from_j, from_k) >= heights_(j, k) || bottom(j, k) >= heights_(from_j, from_k)) return;
        seen_(j, k) = 1;
        open_.emplace_back(j, k);
    }

    [[nodiscard]] int bottom(int j, int k) const { return missing_.size() == 0 ? 0 : missing_(j, k); }

    const Grid<std::uint16_t>& heights_;
    const Grid<std::uint16_t>& missing_;
    Grid<std::uint8_t> seen_;
    std::vector<std::pair<int, int>> open_;
};

int pieces(const Grid<std::uint16_t>& heights, const Grid<std::uint16_t>& missing) {
    return PieceCounter(heights, missing).count();
}

}  // namespace

std::string_view side_name(Side side) {
    constexpr std::string_view kNames[6] = {"floor", "roof", "back", "front", "left", "right"};
    return kNames[side];
}

FitReport fit_report(const FoamPair& foams, const BlockMap& blocks, const DesignSpace& space,
                     const Available& available) {
    FitReport report;
    for (const auto height : foams.lower) report.lower_blocks += height;
    for (const auto height : foams.upper) report.upper_blocks += height;
    for (const auto missing : foams.lower_missing) report.lower_blocks -= missing;
    for (const auto missing : foams.upper_missing) report.upper_blocks -= missing;
    for (std::size_t column = 0; column < blocks.size(); ++column) {
        const CutRun cut = blocks[column], there = available_in(available, column, space.blocks.x);
        const CutRun both{std::max(cut.first, there.first), std::min(cut.end, there.end)};
        report.cut_blocks += cut.none() ? 0 : both.blocks();
        report.outside_blocks += cut.blocks() - (cut.none() ? 0 : both.blocks());
        report.shortened_blocks += space.blocks.x - there.blocks();
    }
    report.foam_mm3 = static_cast<double>(report.lower_blocks + report.upper_blocks) * space.block_volume();
    report.fill_ratio = static_cast<double>(report.lower_blocks + report.upper_blocks) /
                        static_cast<double>(space.block_count() - report.shortened_blocks);
    report.wall_mm = in_millimetres(available.size() == 0 ? thinnest_of(blocks, space.blocks)
                                                          : thinnest_within(available, blocks, space.blocks),
                                    space);
    report.lower_pieces = pieces(foams.lower, foams.lower_missing);
    report.upper_pieces = pieces(foams.upper, foams.upper_missing);
    return report;
}

}  // namespace snug
