#pragma once

#include <span>
#include <vector>

#include "snug/base/grid.h"
#include "snug/base/piece.h"
#include "snug/base/run.h"
#include "snug/foam/block_map.h"
#include "snug/space/design_space.h"

namespace snug {

/// The pieces of foam (section 3.3 of the paper, for any number of layers), lowest first: L layers of items
/// lie between L + 1 pieces. A tray has no uppermost one.
struct Foams {
    /// The blocks that a piece keeps in each column, counted from -x; {0, 0} where it keeps none. So a piece
    /// is a height field from each of its sides.
    std::vector<Grid<Run>> pieces;
    /// For each layer the level where the pieces below and above it meet in columns that no item of it
    /// touches, 0 to nx blocks; never falling.
    std::vector<int> parting;

    [[nodiscard]] const Grid<Run>& piece(Piece piece) const {
        return pieces[static_cast<std::size_t>(piece.index)];
    }
    [[nodiscard]] int layers() const { return static_cast<int>(parting.size()); }
    /// Whether it is a tray: nothing lies on the uppermost layer.
    [[nodiscard]] bool open() const { return !parting.empty() && pieces.size() == parting.size(); }
    [[nodiscard]] Piece at(int index) const { return {index, layers() + 1}; }
    [[nodiscard]] bool has(Piece piece) const { return !open() || !piece.highest(); }
    /// All that there are, the lowest first.
    [[nodiscard]] std::vector<Piece> all() const;
};

/// The pieces around the blocks that each layer cuts, lowest first. Each ends below all that the layers above
/// it cut and begins above all that those below it cut, so that layer by layer everything comes out along x,
/// whatever lies over what. No piece has blocks that do not exist (`available`).
[[nodiscard]] Foams split(std::span<const BlockMap> layers, std::vector<int> parting,
                          const Grid<Run>& available);

/// A tray: the same without what lies on the uppermost layer.
[[nodiscard]] Foams without_lid(Foams foams);

/// The two foams of one layer.
[[nodiscard]] Foams split(const BlockMap& blocks, int parting_level, const Grid<Run>& available);
/// In a plain box, where all blocks exist.
[[nodiscard]] Foams split(const BlockMap& blocks, const DesignSpace& space, int parting_level);

/// Of the closed foams, or of a tray up to its surface. mm.
[[nodiscard]] Vec3d outer_size(const Foams& foams, const DesignSpace& space);

/// The blocks that a half keeps in each column of nx blocks, counted from the half's own side (the lower
/// foam's from -x, the lid's from +x): `end` is how high it reaches. Of a lid that there is not: none.
[[nodiscard]] Grid<Run> kept_runs(const Foams& foams, Half half, int nx);

/// A piece as it is looked at from one of its sides: `from` Half::lower from +x, Half::lid from -x.
struct SeenPiece {
    /// The blocks in each column, counted from where the piece lies: `end` is how high it reaches.
    Grid<Run> kept;
    /// What of the space lies under it, in blocks: none under a piece that lies on the case.
    int under = 0;
};
[[nodiscard]] SeenPiece seen_piece(const Foams& foams, Piece piece, Half from, int nx);
/// From the side that is looked at first.
[[nodiscard]] SeenPiece seen_piece(const Foams& foams, Piece piece, int nx);

}  // namespace snug
