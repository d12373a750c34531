#pragma once

#include <optional>
#include <span>
#include <vector>

#include "snug/search/arrange.h"

// What the several ways to ask for an arrangement share.

namespace snug {

/// What can be refused without a look, and all objects prepared for many.
[[nodiscard]] Result<void> begin_arranging(std::span<Object> objects, const Design& design,
                                           const ArrangeWatch& watch);

/// Of each item whether it stays where it is. `all`: those alone that say so themselves.
[[nodiscard]] std::vector<bool> locked_items(const Design& design, bool all);

/// A case, or so many blocks.
[[nodiscard]] bool has_given_space(const Design& design);

/// The walls that are tried one after the other where a space is given and names none: from thick to thin,
/// each as the design then has it. Empty: what the design says holds.
[[nodiscard]] std::vector<Walls> walls_to_try(const Design& design);

/// arrange() of what has begun. `explain`: where it does not fit the sentence says who is left out, and what
/// would do, which takes a look of its own.
[[nodiscard]] Result<Arrangement> arranged(std::span<Object> objects, Design& design,
                                           const std::vector<bool>& locked, long long work,
                                           const ArrangeWatch& watch, bool explain);

}  // namespace snug
