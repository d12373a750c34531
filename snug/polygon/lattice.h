#pragma once

#include <cmath>
#include <cstdint>

// The one lattice of the plane. Cross-sections, the faces of solids and bores in them have their corners on
// it, so that every question about them (on which side, does it touch, how large) has an exact answer.
//
// A step is 1/1024 mm: a power of two, so float32 holds all steps of 16 m, and what is flat on the lattice is
// flat in STL, PLY and 3MF as well, which no decimal step gives. Sums of steps are exact in any order.
// Where foam is made of whole blocks, block lines are its lattice and need no steps; a face of blocks with an
// opening in it counts each block as the nearest whole number of steps. What people type is decimal, so where
// lengths are only added and compared (pieces on sheets of stock) nothing is rounded at all.

namespace snug {

constexpr int kStepsPerMm = 1024;

/// The nearest whole number of steps, halves upward.
[[nodiscard]] inline std::int64_t in_steps(double mm) {
    return static_cast<std::int64_t>(std::floor(mm * kStepsPerMm + 0.5));
}

/// Exact.
[[nodiscard]] constexpr double in_mm(double steps) {
    return steps / kStepsPerMm;
}

}  // namespace snug
