#include "snug/check/fit_report.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "snug/space/available.h"

namespace snug {
namespace {

using Thinnest = std::array<int, 6>;  // blocks on each side

void thin_by(Thinnest& thinnest, const BlockMap& blocks, Vec3i n) {
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
}

/// How many blocks lie between a cut block and the end of those that exist, going by (dj, dk).
int blocks_to_case(const Grid<Run>& available, int level, int j, int k, int dj, int dk) {
    int count = -1;
    for (; available.contains(j, k); j += dj, k += dk, ++count)
        if (level < available(j, k).first || level >= available(j, k).end) break;
    return std::max(0, count);
}

/// The same within a case that shortens columns. It is convex, so its walls are nearest to the ends of a run.
void thin_within(Thinnest& thinnest, const Grid<Run>& available, const BlockMap& blocks, Vec3i n) {
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
}

std::array<double, 6> walls_of(std::span<const BlockMap> layers, const DesignSpace& space,
                               const Grid<Run>& available) {
    const Vec3i n = space.blocks;
    const bool plain = fills_box(available, n.x);
    Thinnest thinnest{n.x, n.x, n.y, n.y, n.z, n.z};
    for (const BlockMap& blocks : layers)
        plain ? thin_by(thinnest, blocks, n) : thin_within(thinnest, available, blocks, n);
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

long long blocks_below(const Grid<Run>& runs, int level) {
    const Run below{0, static_cast<std::int16_t>(level)};
    long long blocks = 0;
    for (const Run run : runs) blocks += run.common(below).blocks();
    return blocks;
}

long long blocks_of(const Grid<Run>& runs) {
    long long blocks = 0;
    for (const Run run : runs) blocks += run.blocks();
    return blocks;
}

}  // namespace

long long FitReport::foam_blocks() const {
    long long blocks = 0;
    for (const PieceFigures& piece : pieces) blocks += piece.blocks;
    return blocks;
}

FitReport fit_report(const Foams& foams, std::span<const BlockMap> layers, const DesignSpace& space,
                     const Grid<Run>& available) {
    FitReport report;
    report.pieces.clear();
    for (const Grid<Run>& kept : foams.pieces)
        report.pieces.push_back({blocks_of(kept), PieceCounter(kept).count()});
    report.open = foams.open();
    if (report.open) report.pieces.emplace_back();
    report.shortened_blocks = space.block_count() - blocks_of(available);
    const long long there = blocks_below(available, report.open ? foams.parting.back() : space.blocks.x);
    report.cut_blocks = there - report.foam_blocks();
    for (const BlockMap& blocks : layers)
        for (std::size_t column = 0; column < blocks.size(); ++column)
            report.outside_blocks +=
                blocks[column].blocks() - blocks[column].common(available[column]).blocks();
    report.foam_mm3 = static_cast<double>(report.foam_blocks()) * space.block_volume();
    report.fill_ratio = static_cast<double>(report.foam_blocks()) / static_cast<double>(there);
    report.wall_mm = walls_of(layers, space, available);
    return report;
}

}  // namespace snug
