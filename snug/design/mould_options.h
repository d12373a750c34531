#pragma once

#include <optional>
#include <string>

namespace snug {

/// Printed boxes to pour foam or silicone into. The printer's bed and dowels are those of PrintOptions.
struct MouldOptions {
    double wall_mm = 3;    ///< of the box's walls and floor, 0.4 to 100
    double rim_mm = 5;     ///< by which the walls stand above what is poured, 0 to 200
    double draft_deg = 2;  ///< by which upright faces lean so that the foam lets go, 0 to 15
    friend bool operator==(const MouldOptions&, const MouldOptions&) = default;
};

/// What is out of range whatever the foam is, as a sentence; none where all is well.
[[nodiscard]] std::optional<std::string> problem_of(const MouldOptions& options);

}  // namespace snug
