#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "snug/base/grid.h"
#include "snug/base/vec.h"

namespace snug {

/// Where a half is cut apart: block lines in ascending order, the first 0 and the last the half's end. x
/// counts levels from the half's floor, y and z are j and k.
struct PrintCuts {
    std::array<std::vector<int>, 3> lines;
    bool turned = false;  ///< the parts lie on the bed turned by a quarter

    [[nodiscard]] int pieces(int axis) const {
        return static_cast<int>(lines[static_cast<std::size_t>(axis)].size()) - 1;
    }
};

/// The fewest cuts after which every piece is on the bed as equally long as possible. `blocks`: of the half,
/// levels first. Needs a bed that holds a block, see holds_block.
[[nodiscard]] PrintCuts print_cuts(Vec3i blocks, Vec3d block_mm, Vec3d bed_mm);

/// Whether one block finds room on the bed, turned by a quarter if need be.
[[nodiscard]] bool holds_block(Vec3d bed_mm, Vec3d block_mm);

/// One piece of foam that is printed at a time: columns that share sides, with a flat floor.
struct PrintPart {
    Vec3i first;                  ///< its least level, j and k within the half
    int tile = 0;                 ///< the piece of PrintCuts that it comes from
    Grid<std::uint16_t> heights;  ///< blocks from its floor, 0 where it has none; no empty rim
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

[[nodiscard]] PrintLayout print_layout(const Grid<std::uint16_t>& heights, PrintCuts cuts);

}  // namespace snug
