#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "snug/base/grid.h"
#include "snug/base/run.h"
#include "snug/base/vec.h"

namespace snug {

/// Where block lines stand along each axis, in mm, ascending from 0: levels first, then lines across y and z.
using BlockLines = std::array<std::vector<double>, 3>;
[[nodiscard]] BlockLines block_lines(Vec3i blocks, Vec3d block_mm);

/// Where a half is cut apart: block lines in ascending order, the first 0 and the last the half's end. x
/// counts levels from the half's floor, y and z are j and k.
struct PrintCuts {
    std::array<std::vector<int>, 3> lines;
    bool turned = false;  ///< the parts lie on the bed turned by a quarter

    [[nodiscard]] int pieces(int axis) const {
        return static_cast<int>(lines[static_cast<std::size_t>(axis)].size()) - 1;
    }
};

/// The fewest cuts after which every piece is on the bed, about equally long where that goes. `blocks`: of
/// the half, levels first. Needs a bed that holds a block, see holds_block.
[[nodiscard]] PrintCuts print_cuts(Vec3i blocks, Vec3d block_mm, Vec3d bed_mm);
/// The same for lines at any distances, on any of which a half may be cut; `lines` of the cuts counts them.
[[nodiscard]] PrintCuts print_cuts(const BlockLines& lines, Vec3d bed_mm);

/// Whether one block finds room on the bed, turned by a quarter if need be.
[[nodiscard]] bool holds_block(Vec3d bed_mm, Vec3d block_mm);

/// One piece of foam that is printed at a time: columns that share sides. Its floor is flat unless a case
/// shortens the half from below.
struct PrintPart {
    Vec3i first;             ///< its least level, j and k within the half
    int tile = 0;            ///< the piece of PrintCuts that it comes from
    Grid<Run> runs;          ///< its blocks in each column, from its floor; no empty rim
    bool overhangs = false;  ///< some column begins above the floor
    [[nodiscard]] int levels() const;
    [[nodiscard]] long long blocks() const;
};

struct PrintLayout {
    PrintCuts cuts;
    std::vector<PrintPart> parts;
    /// For each piece of the cuts (levels slowest, k fastest) the part in each of its columns, -1 for none.
    std::vector<Grid<int>> part_at;

    [[nodiscard]] int tile(int level_piece, int j_piece, int k_piece) const {
        return (level_piece * cuts.pieces(1) + j_piece) * cuts.pieces(2) + k_piece;
    }
};

/// The part, from 0, that each column of a piece belongs to; -1 for none. `tile`: the piece of the cuts.
using PiecePartition = std::function<Grid<int>(int tile, const Grid<std::uint16_t>& piece)>;

/// Columns of a piece that share sides are one part, unless `partition` says what is.
[[nodiscard]] PrintLayout print_layout(const Grid<std::uint16_t>& heights, PrintCuts cuts,
                                       const PiecePartition& partition = {});
/// Of a half that keeps these blocks, counted from its own side.
[[nodiscard]] PrintLayout print_layout(const Grid<Run>& kept, PrintCuts cuts);

/// What a piece has of a half: blocks above its floor, up to its top. Levels first, then j and k.
[[nodiscard]] Grid<std::uint16_t> piece_of(const Grid<std::uint16_t>& heights, Vec3i first, Vec3i end);

}  // namespace snug
