#pragma once

#include "snug/drawing/page_builder.h"
#include "snug/fabricate/kit/block_grid.h"
#include "snug/fabricate/mould/mould_form.h"
#include "snug/fabricate/mould/mould_parts.h"

namespace snug {

/// One mould from above, as a grid that lies as the other half does with its cavity up, and a section below
/// it.
struct MouldPicture {
    const MouldForm& form;
    BlockGrid grid;
    double scale = 1;  ///< of the page to the mould
    int highest = 0;   ///< blocks that the core stands high at most
    int section = 0;   ///< the row of the section: the first in which the core is so high

    /// As large as a page of this width and its usual height let it be; see move_to().
    MouldPicture(const MouldForm& in_form, double width);
    [[nodiscard]] double height() const;
    /// Puts the upper left corner of both views, in the middle of `width`.
    void move_to(Vec2d corner, double width) {
        grid.corner = corner + Vec2d{(width - form.size().z * scale) / 2 + wall(), kGridMargin + wall()};
    }
    [[nodiscard]] double wall() const { return form.mm(1, form.margin) * scale; }
    [[nodiscard]] double column_mm() const { return form.mm(2, form.margin + 1) - form.mm(2, form.margin); }
    [[nodiscard]] double row_mm() const { return form.mm(1, form.margin + 1) - form.mm(1, form.margin); }
    [[nodiscard]] double level_mm() const { return form.mm(0, 2) - form.mm(0, 1); }
    [[nodiscard]] bool has_numbers() const;  ///< in its cells
    /// Blocks that the core stands high.
    [[nodiscard]] int core(int row, int column) const {
        return form.heights(grid.row_from_back(row) + form.margin, column + form.margin) - 1;
    }
    /// A place in the assembled mould (to the right, to the back) from above.
    [[nodiscard]] Vec2d at(double x, double y) const {
        return grid.corner - Vec2d{wall(), wall()} + Vec2d{x, form.size().y - y} * scale;
    }
    /// A place in the section (to the right, up).
    [[nodiscard]] Vec2d in_section(double x, double up) const;
};

/// Both views, with BACK, the heights of the core and the parts of the mould.
void draw_mould(PageBuilder& page, const MouldPicture& picture, const Mould& mould);

/// What the shades of the core mean.
void draw_core_scale(PageBuilder& page, const MouldPicture& picture, Vec2d at);

}  // namespace snug
