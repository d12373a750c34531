#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "snug/base/side.h"
#include "snug/base/vec.h"
#include "snug/design/fit_options.h"
#include "snug/foam/block_map.h"
#include "snug/foam/foams.h"
#include "snug/space/design_space.h"

namespace snug {

/// A recess through the whole height of a piece at its outer edge, for the hand that lifts it out of the
/// case.
struct LiftSlot {
    Piece piece;
    Side side = kBack;  ///< of the piece: back, front, left or right
    double at_mm = 0;   ///< its middle along that side, in design coordinates
    Vec3d size_mm;      ///< extent along y and z; x is 0
};

struct LiftSlots {
    std::vector<LiftSlot> slots;
    std::vector<Piece> without;  ///< pieces that have no room for two slots
};

/// Cuts two slots opposite each other out of every piece, but the lowest where there is a lid: that stays in
/// the case, while a tray is lifted out of its drawer. Whole columns of the piece go, from its edge inwards,
/// as near to the middle of both sides as they leave foam of at least `between_mm` (one block at least) to
/// what the layers cut. So pieces stay height fields from both sides, and only lose blocks. `layers`: what
/// each layer cuts, as for split().
[[nodiscard]] LiftSlots cut_lift_slots(Foams& foams, std::span<const BlockMap> layers,
                                       const DesignSpace& space, const LiftOptions& options,
                                       double between_mm);

}  // namespace snug
