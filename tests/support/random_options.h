#pragma once

#include <string>
#include <utility>

#include "snug/design/project.h"

#include "tests/support/random.h"

namespace snug::test {

/// A design that checked() takes, with options of every kind changed, within the ranges of the table.
[[nodiscard]] Design random_options(Random& random);

/// Of one object.
[[nodiscard]] inline Project project_of(const std::string& name, Design design = {}) {
    return {{{{name, 1, std::string(64, 'a')}, {}}}, std::move(design)};
}

}  // namespace snug::test
