#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "snug/base/grid.h"
#include "snug/polygon/plan_region.h"

// A height field whose upright faces lean, as a stack of slabs: within each the cross-section grows evenly
// from its top to its bottom, so that every face is flat and nothing overhangs.

namespace snug {

/// How upright faces lean: below `from` they move outward by `slope` mm for each mm that they go down; above,
/// they stand upright.
struct Draft {
    double slope = 0;
    int from = 0;  ///< steps above the floor

    /// Steps by which a face has moved at this height.
    [[nodiscard]] std::int64_t moved_at(int height) const;
};

struct DraftSlab {
    int top = 0, bottom = 0;  ///< steps above the floor
    int growth = 0;           ///< steps by which the cross-section is greater at the bottom on every side
    PlanRegion region;        ///< at the top
};

/// A height field with its block lines in steps, ascending: `levels` from the floor (0) upward, one more than
/// the greatest height.
struct SteppedField {
    const Grid<std::uint16_t>& heights;
    std::span<const int> levels, y, z;

    [[nodiscard]] PlanBox box() const { return {{y.front(), z.front()}, {y.back(), z.back()}}; }
};

/// The slabs from the top down, between levels `first` and `last` of the field. `above`: the cross-section of
/// what stands on it, which goes on. The solid keeps within the field's box, holds every column, and fills
/// what would close within a slab: less than 0.05 mm beyond twice the slab's growth, which is at most half a
/// millimetre.
[[nodiscard]] std::vector<DraftSlab> draft_slabs(const SteppedField& field, int first, int last,
                                                 const Draft& draft, const PlanRegion& above);

/// The cross-section at the bottom of a slab.
[[nodiscard]] PlanRegion bottom_of(const DraftSlab& slab, const PlanBox& box);

}  // namespace snug
