#pragma once

#include "snug/base/grid.h"
#include "snug/base/run.h"
#include "snug/solid/solid.h"

namespace snug::test {

/// Blocks of 2 mm, so that every lattice point has whole coordinates.
[[nodiscard]] inline DesignSpace whole_space(const Grid<Run>& runs, int levels) {
    return {{levels, runs.ny(), runs.nz()}, {2, 2, 2}};
}

/// The solid of these runs, counted from the half's own side, in whole_space, against an array of its blocks:
/// closed by indices and welded, outward, just these faces and no inner one, vertices at every true corner
/// and nowhere else, none inside an edge, none in which the surface is pinched.
void expect_sound(const Solid& solid, const Grid<Run>& runs, int levels, Half half);

}  // namespace snug::test
