#pragma once

#include "snug/design/design.h"

#include "tests/support/random.h"

namespace snug::test {

/// A design that checked() takes, with options of every kind changed, within the ranges of the table.
[[nodiscard]] Design random_options(Random& random);

}  // namespace snug::test
