#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "snug/base/progress.h"
#include "snug/base/result.h"

namespace snug {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// minimise cost . x  subject to  row_lower <= A x <= row_upper,  lower <= x <= upper.
/// A is stored by columns: column c has the entries first[c] to first[c + 1] - 1 of `row` and `value`.
struct LinearProgram {
    std::vector<double> cost, lower, upper;
    std::vector<double> row_lower, row_upper;
    std::vector<int> first{0};
    std::vector<int> row;
    std::vector<double> value;

    [[nodiscard]] int columns() const { return static_cast<int>(cost.size()); }
    [[nodiscard]] int rows() const { return static_cast<int>(row_lower.size()); }
};

struct LpSolution {
    bool feasible = false;  ///< false: no x satisfies all rows and bounds
    std::vector<double> x;  ///< of an optimum; empty where there is none
    /// Of each row: how the least cost grows with its bounds. May be empty.
    std::vector<double> price;
};

/// Solves a linear program, or fails with kind `cancelled` where the progress says so. Not every build has
/// one.
using LpSolver = std::function<Result<LpSolution>(const LinearProgram&, const Progress&)>;

}  // namespace snug
