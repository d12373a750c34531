#pragma once

#include <span>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/object/object.h"
#include "snug/search/shock_wishes.h"

namespace snug {

/// The design with the least foam, in steps of 5 mm, with which every item meets no more than it bears in a
/// drop on any side, by the high end of what is estimated (check/protection.h): its walls and, where items
/// would meet through the foam between them, more of that. Items that have places are moved apart along y and
/// z for it, in whole blocks, unless one of them is locked. Where items reach one another, it need not be the
/// least. `pack_it` packs the objects by a design. Fails with kind `usage` where the design says no foam of
/// known curve, no mass, no drop or nothing that it must bear, where its space is not fitted, or where an
/// object is read in pieces or as points; with kind `does_not_fit` where 400 mm would not do, or the pack
/// became too heavy for the rule of its drop.
[[nodiscard]] Result<Design> protecting_walls(std::span<const Object> objects, const Design& design,
                                              const PackIt& pack_it, const Progress& progress = {});

}  // namespace snug
