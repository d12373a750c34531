#include "snug/check/fit_report.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "snug/space/available.h"

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
int blocks_to_case(const Grid<Run>& available, int level, int j, int k, int dj, int dk) {
    int count = -1;
    for (; available.contains(j, k); j += dj, k += dk, ++count)
        if (level < available(j, k).first || level >= available(j, k).end) break;
    return std::max(0, count);
}

/// The same within a case that shortens columns. It is convex, so its walls are nearest to the ends of a run.
std::array<int, 6> thinnest_within(const Grid<Run>& available, const BlockMap& blocks, Vec3i n) {
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

/// Pieces are connected areas of columns: those of a height field all stand on the same plane, and where a
/// case shortens them neighbours hang together if some level is in both.
class PieceCounter {
  public:
    explicit PieceCounter(const Grid<Run>& kept) : kept_(kept), seen_(kept.ny(), kept.nz()) {}

    int count() {
        int pieces = 0;
        for (int j = 0; j < kept_.ny(); ++j) {
            for (int k = 0; k < kept_.nz(); ++k) {
                if (kept_(j, k).none() || seen_(j, k)) continue;
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
                visit(kept_(row, column), row + dj, column + dk);
        }
    }

    void visit(Run from, int j, int k) {
        if (!kept_.contains(j, k) || seen_(j, k) || !from.meets(kept_(j, k))) return;
        seen_(j, k) = 1;
        open_.emplace_back(j, k);
    }

    const Grid<Run>& kept_;
    Grid<std::uint8_t> seen_;
    std::vector<std::pair<int, int>> open_;
};

long long blocks_of(const Grid<Run>& runs) {
    long long blocks = 0;
    for (const Run run : runs) blocks += run.blocks();
    return blocks;
}

}  // namespace

FitReport fit_report(const Foams& foams, const BlockMap& blocks, const DesignSpace& space,
                     const Grid<Run>& available) {
    const Grid<Run>&lower = foams.piece(Half::lower), &lid = foams.piece(Half::lid);
    FitReport report;
    report.lower_blocks = blocks_of(lower);
    report.upper_blocks = blocks_of(lid);
    for (std::size_t column = 0; column < blocks.size(); ++column) {
        const CutRun cut = blocks[column];
        const Run there = available[column];
        const long long inside = cut.none() ? 0 : cut.common(there).blocks();
        report.cut_blocks += inside;
        report.outside_blocks += cut.blocks() - inside;
        report.shortened_blocks += space.blocks.x - there.blocks();
    }
    report.foam_mm3 = static_cast<double>(report.lower_blocks + report.upper_blocks) * space.block_volume();
    report.fill_ratio = static_cast<double>(report.lower_blocks + report.upper_blocks) /
                        static_cast<double>(space.block_count() - report.shortened_blocks);
    report.wall_mm = in_millimetres(fills_box(available, space.blocks.x)
                                        ? thinnest_of(blocks, space.blocks)
                                        : thinnest_within(available, blocks, space.blocks),
                                    space);
    report.lower_pieces = PieceCounter(lower).count();
    report.upper_pieces = PieceCounter(lid).count();
    return report;
}

}  // namespace snug
