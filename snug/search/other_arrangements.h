#pragma once

#include <span>
#include <vector>

#include "snug/search/arrange.h"

namespace snug {

/// An arrangement, and the design that has it.
struct ArrangedDesign {
    Design design;
    Arrangement arrangement;
};

/// A few arrangements to choose from beside the best one: in a space that is narrower or shorter than its own
/// by a fifth, where the space is open, and with a layer more or fewer, where nobody chose the layers. None
/// that takes half as much again, and no two in spaces of the same shape; the least volume first. `start`:
/// the design that arrange() was given; `best`: what it made of it. None where items are locked. `work`:
/// together.
[[nodiscard]] std::vector<ArrangedDesign> other_arrangements(std::span<Object> objects, const Design& start,
                                                             const Design& best, long long work,
                                                             const ArrangeWatch& watch = {});

}  // namespace snug
