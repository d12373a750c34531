#pragma once

#include "snug/base/vec.h"

// What works along x serves the other axes, too, where coordinates are named anew.

namespace snug {

/// The axis first, the others behind it in their order, so that right-handed stays right-handed.
template <class T>
[[nodiscard]] constexpr Vec3<T> with_first(Vec3<T> v, int axis) {
    return {v[axis], v[(axis + 1) % 3], v[(axis + 2) % 3]};
}

/// Back again.
template <class T>
[[nodiscard]] constexpr Vec3<T> with_own_axes(Vec3<T> v, int axis) {
    Vec3<T> own;
    for (int i = 0; i < 3; ++i) own[(axis + i) % 3] = v[i];
    return own;
}

}  // namespace snug
