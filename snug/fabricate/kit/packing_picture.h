#pragma once

#include <vector>

#include "snug/drawing/page_builder.h"
#include "snug/foam/foams.h"
#include "snug/mesh/mesh.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"
#include "snug/space/placement.h"

namespace snug {

struct PictureParts {
    bool object = false;
    bool lid = false;
};

/// What lies in a layer. References live as long as the packing.
struct PackedLayer {
    int layer = 1;
    const Mesh& mesh;
    const Placement& placement;
    std::vector<NumberedPlace> numbered{};  ///< see numbered_places()
};

/// The foam below a layer as it lies on a table, seen into its cavity; with the layer's items in it and the
/// foam above turned over its BACK edge where they are asked for. Fitted into a rectangle of the page and
/// centred.
void draw_packing_picture(PageBuilder& page, Vec2d corner, Vec2d size, PictureParts parts, const Foams& foams,
                          const DesignSpace& space, const PackedLayer& layer);

}  // namespace snug
