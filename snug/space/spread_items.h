#pragma once

#include <vector>

#include "snug/base/vec.h"
#include "snug/space/item.h"

namespace snug {

/// How far each item is to be moved along y and z, so that between any two that stand beside each other lies
/// `more_mm` more along these axes: the first of a row stays, the next one goes so far, and so on. Items of
/// one group go together. They stand beside each other along an axis where their rooms overlap across it.
[[nodiscard]] std::vector<Vec3d> shifts_apart(const std::vector<Item>& items, Vec3d more_mm);

}  // namespace snug
