#pragma once

#include <utility>
#include <vector>

namespace snug {

/// A level for each layer, the lowest first; of one layer a number alone.
struct PartingLevels {
    std::vector<int> each{0};

    PartingLevels() = default;
    PartingLevels(int level) : each{level} {}
    PartingLevels(std::vector<int> levels) : each(std::move(levels)) {}
    friend bool operator==(const PartingLevels&, const PartingLevels&) = default;
};

}  // namespace snug
