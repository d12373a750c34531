#pragma once

#include <span>
#include <string_view>

#include "snug/picture/canvas.h"
#include "snug/picture/isometric.h"
#include "snug/picture/relief.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"
#include "snug/words/words.h"

// What the preview says besides the foam: names, sizes, the hinge, axes, legend.

namespace snug {

constexpr double kPageWidth = 1200;  // px

/// LOWER, MIDDLE 1 or LID: on the half's front wall (lower) or right wall (lid) where there is room, else on
/// the table beside.
void draw_half_name(Canvas& canvas, const Page& page, const Relief& relief, Half half, Piece piece);

/// Sizes along the edges: the columns' two directions and the height at the left corner of the lower half,
/// and the height of the lid.
void draw_sizes(Canvas& canvas, const Page& page, const Relief& relief, Half half, const DesignSpace& space);

/// The line about which the lid was turned, to be drawn between the halves, and BACK at its end.
void draw_hinge(Canvas& canvas, const Page& page, const DesignSpace& space);
[[nodiscard]] Vec2d back_label_centre(const Page& page, const DesignSpace& space);
void draw_back_label(Canvas& canvas, const Page& page, const DesignSpace& space);

/// The numbers of items over their places, in design coordinates, in the lower half.
void draw_numbers(Canvas& canvas, const Page& page, const OpenedPair& pair,
                  std::span<const NumberedPlace> places);

/// The design axes as the lower half has them.
void draw_axes(Canvas& canvas, Vec2d at);

/// What the legend may cover from `at`.
[[nodiscard]] Vec2d legend_size(int pieces);  // px

/// What the colours of the pieces mean and the size of the closed box or of the tray; `at` is its upper left
/// corner.
void draw_legend(Canvas& canvas, Vec2d at, const DesignSpace& space, const Foams& foams, bool with_object,
                 Language language);

}  // namespace snug
