#pragma once

#include "snug/base/grid.h"
#include "snug/base/half.h"
#include "snug/base/result.h"
#include "snug/design/brick_options.h"
#include "snug/design/brick_parts.h"
#include "snug/fabricate/kit/workshop_pack.h"

namespace snug {

/// How many studs and plates a block of the design is.
struct BlockInStuds {
    int rows = 1, columns = 1;  ///< studs along y and z
    int plates = 3;             ///< along x
};

/// Fails (kind usage) for blocks that no brick has, with the nearest that work: x a multiple of 9.6 mm
/// (bricks) or 3.2 mm (plates), y and z multiples of 8 mm.
[[nodiscard]] Result<BlockInStuds> block_in_studs(Vec3d block_mm, BrickUnit unit);

/// What is to be built of one half, as it stands on the table: (row, column) of studs as in brick_build.h.
struct BrickShape {
    Half half = Half::lower;
    int layer_plates = kPlatesInBrick;  ///< of a layer: 3 of bricks, 1 of plates
    Grid<int> top;                      ///< layers up to where the foam ends, from the half's floor; 0: none
    Grid<int> first;                    ///< layers that the case leaves out below the foam
    Grid<char> rim;                     ///< where the halves meet: the tops that may be tiled

    [[nodiscard]] int rows() const { return top.ny(); }
    [[nodiscard]] int columns() const { return top.nz(); }
    [[nodiscard]] int layers() const;
    [[nodiscard]] bool has(int row, int column, int layer) const {
        return top.contains(row, column) && layer >= first(row, column) && layer < top(row, column);
    }
    /// Studs of all layers.
    [[nodiscard]] long long studs() const;
};

/// `plates_a_layer`: 3 or 1, a divisor of the block's plates.
[[nodiscard]] BrickShape brick_shape(const FoamDesign& design, Half half, const BlockInStuds& block,
                                     int plates_a_layer);

}  // namespace snug
