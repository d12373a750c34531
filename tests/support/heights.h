#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "snug/foam/foams.h"

namespace snug::test {

/// How high each column of a foam reaches, in blocks from its own side; 0 where it has none.
using Heights = Grid<std::uint16_t>;

[[nodiscard]] inline Heights filled(int ny, int nz, int height) {
    return {ny, nz, static_cast<std::uint16_t>(height)};
}

/// Of a half of foams that are nx blocks high.
[[nodiscard]] inline Heights heights_of(const Foams& foams, Half half, int nx) {
    const Grid<Run> kept = kept_runs(foams, half, nx);
    Heights heights(kept.ny(), kept.nz());
    for (std::size_t i = 0; i < kept.size(); ++i) heights[i] = static_cast<std::uint16_t>(kept[i].end);
    return heights;
}
[[nodiscard]] inline Heights lower_heights(const Foams& foams) {
    return heights_of(foams, Half::lower, 0);
}
[[nodiscard]] inline Heights upper_heights(const Foams& foams, int nx) {
    return heights_of(foams, Half::lid, nx);
}

/// Two foams in a box that is nx blocks high. They may overlap.
[[nodiscard]] inline Foams foams_of_heights(const Heights& lower, const Heights& upper, int parting, int nx) {
    Grid<Run> below(lower.ny(), lower.nz()), above = below;
    for (std::size_t i = 0; i < lower.size(); ++i) {
        if (lower[i] > 0) below[i] = {0, static_cast<std::int16_t>(lower[i])};
        if (upper[i] > 0)
            above[i] = {static_cast<std::int16_t>(nx - upper[i]), static_cast<std::int16_t>(nx)};
    }
    return {{std::move(below), std::move(above)}, {parting}};
}

/// Foams cut down to what exists.
inline void shorten(Foams& foams, const Grid<Run>& available) {
    for (Grid<Run>& piece : foams.pieces)
        for (std::size_t column = 0; column < available.size(); ++column) {
            const Run kept = piece[column].common(available[column]);
            piece[column] = kept.none() ? Run{} : kept;
        }
}

}  // namespace snug::test
