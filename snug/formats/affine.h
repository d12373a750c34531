#pragma once

#include <array>
#include <cstddef>

#include "snug/base/vec.h"

namespace snug {

/// An affine map of space, as the nodes of a scene place what they show; points are columns.
struct Affine {
    std::array<Vec3d, 3> row{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
    Vec3d shift;

    [[nodiscard]] Vec3d turned(Vec3d p) const { return {dot(row[0], p), dot(row[1], p), dot(row[2], p)}; }
    [[nodiscard]] Vec3d operator()(Vec3d p) const { return turned(p) + shift; }
    /// First `inner`, then this.
    [[nodiscard]] Affine operator*(const Affine& inner) const {
        Affine result;
        for (int column = 0; column < 3; ++column) {
            const Vec3d of{inner.row[0][column], inner.row[1][column], inner.row[2][column]};
            const Vec3d at = turned(of);
            for (int i = 0; i < 3; ++i) result.row[static_cast<std::size_t>(i)][column] = at[i];
        }
        result.shift = (*this)(inner.shift);
        return result;
    }
    /// Turns surfaces inside out.
    [[nodiscard]] bool mirrors() const { return dot(cross(row[0], row[1]), row[2]) < 0; }
    friend bool operator==(const Affine&, const Affine&) = default;
};

[[nodiscard]] inline Affine scaling(double factor) {
    return {{Vec3d{factor, 0, 0}, Vec3d{0, factor, 0}, Vec3d{0, 0, factor}}, {}};
}

}  // namespace snug
