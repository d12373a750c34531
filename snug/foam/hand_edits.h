#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "snug/base/grid.h"
#include "snug/base/message.h"
#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/base/run.h"
#include "snug/base/vec.h"
#include "snug/design/hand_edit.h"
#include "snug/foam/block_map.h"
#include "snug/object/object.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"

namespace snug {

/// What came of a hand's edit.
struct EditOutcome {
    std::size_t edit = 0;            ///< of Design::edits
    int blocks = 0;                  ///< taken out of the foam, or, below 0, put back; 0: it does not apply
    std::optional<Message> why_not;  ///< it does not apply
    std::optional<double> left_mm;   ///< at least so much of the clearance, where it was put back into that
    Vec3d where;                     ///< the column's middle at the face, in design coordinates
};

/// The foams as they are computed, which edits change.
struct EditedFoam {
    std::span<const Object> objects;
    const std::vector<Item>& items;
    const DesignSpace& space;
    const Grid<Run>& available;
    const std::vector<int>& parting;  ///< of each layer
    bool open = false;                ///< a tray
};

/// Changes what each layer of items cuts (`layers`, the lowest first) by what a hand takes out or puts back,
/// one edit after the other. An edit applies as a whole or not at all: not where its piece or its column is
/// not there, where a piece has fewer blocks or less was cut, and never where foam would enter an item or
/// what its zones keep free. Into the clearance it may. The pieces stay height fields. Fails as item_depths()
/// does, only where foam is put back.
[[nodiscard]] Result<std::vector<EditOutcome>> apply_edits(const HandEdits& edits, const EditedFoam& foam,
                                                           std::vector<BlockMap>& layers,
                                                           const Progress& progress = {});

}  // namespace snug
