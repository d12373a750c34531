#pragma once

#include "snug/base/piece.h"
#include "snug/check/gap.h"
#include "snug/picture/canvas.h"
#include "snug/space/design_space.h"
#include "snug/words/words.h"

namespace snug {

/// The pieces around a layer.
struct LayerPieces {
    Piece below = Half::lower, above = Half::lid;
    bool covered = true;  ///< not the uppermost of a tray, above which there is no piece
};

/// Two maps of the gap of a layer, side by side under a drawing of kPageWidth: the piece below as it is seen
/// from above (k to the right, j downward) and the one above seen into its cavity (k to the right, j upward).
/// Colours say how deep the gap is in each column, on average, and whether steps or undercuts make it; a ring
/// shows where the half's largest ball fits. At most 120 cells an axis. Gives the px that they take from
/// `top` on.
double draw_gap_maps(Canvas& canvas, const GapReport& gap, const LayerPieces& pieces,
                     const DesignSpace& space, double top, Language language = Language::english);

}  // namespace snug
