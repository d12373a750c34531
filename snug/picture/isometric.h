#pragma once

#include "snug/base/vec.h"
#include "snug/base/vec2.h"
#include "snug/space/design_space.h"

// The preview's two changes of coordinates: design -> scene (the two halves opened like a book on a table) ->
// screen.
//
// Scene: x to the right (the columns' k), y towards the viewer, z up; mm. The hinge is the line y = z = 0.
// The top of each half's rim lies at z = 0, so opening the book is one turn by 180 degrees about the hinge.

namespace snug {

/// Where a scene point is seen, in mm of the drawing before it is scaled to the page.
struct Projected {
    Vec2d at;
    double nearness = 0;  ///< towards the viewer; the greater hides the smaller
};

/// Parallel projection from above, from the front and a little from the right: the +k side (right), the side
/// towards the viewer (front) and the tops are seen.
[[nodiscard]] Projected project(Vec3d scene);

/// How a scene appears on the page.
struct Page {
    double scale = 1;  ///< px per mm of the drawing
    Vec2d shift;

    [[nodiscard]] Vec2d at(Vec2d drawing) const { return drawing * scale + shift; }
    [[nodiscard]] Vec2d at(Vec3d scene) const { return at(project(scene).at); }
};

/// The foam pair as it lies open, the lid turned over its BACK edge (-y).
struct OpenedPair {
    double back_y = 0;     ///< design y of the BACK edges
    double parting_x = 0;  ///< design x where the halves meet
    double half_gap = 0;   ///< from the hinge to either BACK edge, mm

    [[nodiscard]] Vec3d lower(Vec3d design) const {
        return {design.z, design.y - back_y + half_gap, design.x - parting_x};
    }
    [[nodiscard]] Vec3d lid(Vec3d design) const {
        return {design.z, back_y - design.y - half_gap, parting_x - design.x};
    }
};
[[nodiscard]] OpenedPair opened(const DesignSpace& space, int parting_level);

}  // namespace snug
