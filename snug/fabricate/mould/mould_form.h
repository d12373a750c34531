#pragma once

#include <array>
#include <cstdint>

#include "snug/base/grid.h"
#include "snug/base/half.h"
#include "snug/design/mould_options.h"
#include "snug/fabricate/printing/print_parts.h"
#include "snug/fabricate/printing/print_solid.h"

namespace snug {

/// The mould of a half before its faces lean: an open box in which the half is cast cavity down. Its floor
/// carries the core, as high in each column as the half has blocks less than in its highest one, so what is
/// poured reaches the half's outer side at the pour level. There the walls have a narrow ledge, a line to
/// pour to, and the rim stands behind it. At the corner of row A and column 1 the rim is left out, to tell
/// BACK by.
struct MouldForm {
    Half half = Half::lower;
    Grid<std::uint16_t> heights;  ///< levels above the bottom: columns in the middle, walls around
    BlockLines lines;             ///< levels, and lines along y and z, with those of floor and walls
    int margin = 0;               ///< rows and columns of the walls before the first column
    int pour_level = 0;

    [[nodiscard]] double mm(int axis, int line) const {
        return lines[static_cast<std::size_t>(axis)][static_cast<std::size_t>(line)];
    }
    /// Of the assembled mould: levels, y, z.
    [[nodiscard]] Vec3d size() const { return {lines[0].back(), lines[1].back(), lines[2].back()}; }
    /// A mould stands as its half lies turned over: the lower one as the lid is seen, and the other way
    /// round.
    [[nodiscard]] PrintPose pose(bool turned) const { return {half == Half::lower, turned}; }
};

/// `foam`: blocks kept in each column of the half, at least one somewhere.
[[nodiscard]] MouldForm mould_form(Half half, const Grid<Run>& foam, Vec3d block_mm,
                                   const MouldOptions& options);

/// Which lines a mould may be cut apart along, by their numbers: those between columns and between levels of
/// blocks, so that walls and floor never come alone.
[[nodiscard]] std::array<std::vector<int>, 3> cut_lines(const MouldForm& form);

}  // namespace snug
