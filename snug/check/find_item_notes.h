#pragma once

#include <vector>

#include "snug/base/finding.h"
#include "snug/space/item.h"

namespace snug {

/// What a person who packs several items should know of their order: one that lies above a lighter one
/// (`heavy_above`), and two of different objects whose boxes are so alike that either would go into the
/// other's pocket (`mixed_up`). Notes, a few of each.
void find_item_notes(const std::vector<Item>& items, std::vector<Finding>& findings);

}  // namespace snug
