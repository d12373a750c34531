#pragma once

#include <vector>

#include "snug/base/grid.h"
#include "snug/base/half.h"
#include "snug/base/vec.h"
#include "snug/foam/foams.h"
#include "snug/picture/isometric.h"
#include "snug/space/design_space.h"

namespace snug {

/// One piece of foam as it lies open in the scene (isometric.h), cavity up: a height field whose rows run
/// from the back towards the viewer and whose columns run to the right.
struct Relief {
    Grid<int> layers;                 ///< blocks kept: (row, column)
    std::vector<double> front_faces;  ///< scene y where each row begins, and where the last one ends
    std::vector<double> right_faces;  ///< scene x where each column begins, and where the last one ends
    double bottom = 0;                ///< scene z of what it lies on
    double layer_mm = 0;
    int blocks_per_cell = 1;  ///< more where the half has more columns than a drawing can show
    Grid<int> missing;        ///< of the layers, from the bottom, that the case or a cavity below leaves out

    [[nodiscard]] double height(int row, int column) const { return bottom + layers(row, column) * layer_mm; }
    [[nodiscard]] int fewest_layers() const;
};

/// `half`: whether it lies as the lower or as the upper piece of the pair.
[[nodiscard]] Relief relief(const Foams& foams, Piece piece, const DesignSpace& space, const OpenedPair& pair,
                            Half half);
/// Of the two foams of one layer.
[[nodiscard]] Relief relief(const Foams& foams, const DesignSpace& space, const OpenedPair& pair, Half half);

enum class FaceSide { top, front, right };

/// A visible rectangle of a relief: corners origin, origin + across, origin + across + along, origin + along.
/// A top reaches across to the right and along to the viewer; a front wall to the right and down; a right
/// wall to the viewer and down. Each way it covers that many blocks (or cells of the relief).
struct Face {
    FaceSide side = FaceSide::top;
    Vec3d origin, across, along;
    int cells_across = 1;
    int cells_along = 1;
};

/// Every face that can be seen, hidden before hiding: drawn in this order, later faces cover earlier ones.
/// Runs of equal height are one face.
[[nodiscard]] std::vector<Face> visible_faces(const Relief& relief);

/// One piece from one side, ready to be drawn.
struct PieceScene {
    Piece piece;
    Relief relief;
    std::vector<Face> faces;
};
/// `half`: whether it lies as the lower or as the upper piece of the pair.
[[nodiscard]] PieceScene piece_scene(const Foams& foams, Piece piece, const DesignSpace& space,
                                     const OpenedPair& pair, Half half);

}  // namespace snug
