#pragma once

#include <optional>
#include <span>
#include <vector>

#include "snug/base/side.h"
#include "snug/drawing/drawing.h"
#include "snug/foam/foams.h"
#include "snug/mesh/mesh.h"
#include "snug/picture/outline.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

namespace snug {

/// What is drawn in a closed case. References live as long as the packing.
struct FallingMesh {
    const Mesh& mesh;
    const Placement& placement;
};

/// A closed case just above the ground, the side down that it falls on: seen from its front, of back and
/// front from its right. mm, x to the right and y downward, from the middle of the case.
struct FallPicture {
    struct Band {
        Piece piece;
        Loop outline;
    };
    Side face = kFloor;
    Vec2d size;
    std::vector<Band> foams;  ///< as if nothing were cut
    std::vector<Loop> items;
};
/// One for each side, by Side.
[[nodiscard]] std::vector<FallPicture> fall_pictures(const Foams& foams, const DesignSpace& space,
                                                     std::span<const FallingMesh> meshes);

/// A part of such a picture on a page.
struct FallShape {
    std::vector<Loop> loops;
    bool closed = true;
    std::optional<Color> fill, stroke;
    double weight = 1;  ///< of the stroke, in the page's finest lines
};
/// Into rectangles of this size, all at one scale: the shapes of a picture, back to front, from the
/// rectangle's upper left corner on.
[[nodiscard]] double fall_scale(std::span<const FallPicture> pictures, Vec2d size);
[[nodiscard]] std::vector<FallShape> fall_shapes(const FallPicture& picture, double scale, Vec2d size);

}  // namespace snug
