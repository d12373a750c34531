#pragma once

#include <span>
#include <vector>

#include "snug/base/vec.h"
#include "snug/picture/isometric.h"
#include "snug/picture/outline.h"
#include "snug/picture/relief.h"

namespace snug {

/// The object's outlines in the drawing's mm, outer ones clockwise, holes the other way round.
struct ObjectOutlines {
    std::vector<Loop> whole;    ///< as if nothing stood before it
    std::vector<Loop> visible;  ///< what the foam does not hide
    std::vector<std::vector<Loop>>
        shades;  ///< the visible parts that turn from the light, each within the last
};

/// `vertices` are the mesh's, projected; `foam` hides; no detail finer than `finest_mm` is kept. Any
/// triangles will do: they are drawn into an image and its outlines traced. None where there are no
/// triangles.
[[nodiscard]] ObjectOutlines object_outlines(std::span<const Projected> vertices,
                                             std::span<const Triangle> triangles, std::span<const Face> foam,
                                             double finest_mm);

}  // namespace snug
