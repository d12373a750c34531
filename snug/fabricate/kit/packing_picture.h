#pragma once

#include <span>

#include "snug/drawing/page_builder.h"
#include "snug/foam/foams.h"
#include "snug/mesh/mesh.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

namespace snug {

struct PictureParts {
    bool object = false;
    bool lid = false;
};

/// The lower foam as it lies on a table, seen into its cavity; with the object in it and the lid turned over
/// its BACK edge where they are asked for. Fitted into a rectangle of the page and centred. `numbered`: where
/// items are numbered from 1, in design coordinates.
void draw_packing_picture(PageBuilder& page, Vec2d corner, Vec2d size, PictureParts parts, const Foams& foams,
                          const DesignSpace& space, const Mesh& mesh, const Placement& placement,
                          std::span<const Vec3d> numbered = {});

}  // namespace snug
