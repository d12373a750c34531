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

/// What is tried one after the other in a space that is given, before what the design itself says: walls from
/// thick to thin where it names none, first with room for hands beside each item where it has notches. Rather
/// without that room than without walls.
[[nodiscard]] std::vector<Design> wishes_to_try(const Design& design);
/// An arrangement by a wish, with the walls and notches that were asked for.
[[nodiscard]] Design as_asked(Design arranged, const Design& asked);

/// arrange() of what has begun. `explain`: where it does not fit the sentence says who is left out, and what
/// would do, which takes a look of its own.
[[nodiscard]] Result<Arrangement> arranged(std::span<Object> objects, Design& design,
                                           const std::vector<bool>& locked, long long work,
                                           const ArrangeWatch& watch, bool explain);

}  // namespace snug
