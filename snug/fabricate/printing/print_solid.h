#pragma once

#include <span>

#include "snug/base/vec.h"
#include "snug/design/print_options.h"
#include "snug/fabricate/printing/print_joints.h"
#include "snug/fabricate/printing/print_parts.h"
#include "snug/fabricate/printing/sunk_letters.h"
#include "snug/solid/solid.h"

namespace snug {

/// How a half lies on the bed: cavity up. The lower foam is seen as from +x (k to the right, j to the front),
/// the lid as from -x (k to the right, j to the back); turned by a quarter if that saves cuts. Never
/// mirrored.
struct PrintPose {
    bool lid = false;
    bool turned = false;
};

/// From levels, y, z to the bed. Levels, y and z are a mirror image of a lid's own coordinates and, put as z,
/// y, x, of themselves: the lower foam's y is turned round, the lid's triangles must be.
template <class T>
[[nodiscard]] Vec3<T> on_bed(Vec3<T> p, PrintPose pose) {
    const Vec3<T> seen{p.z, pose.lid ? p.y : -p.y, p.x};
    return pose.turned ? Vec3<T>{-seen.y, seen.x, seen.z} : seen;
}

/// Of the lattice of a part's openings, that a block counts along each axis: of a block of any size a whole
/// number.
[[nodiscard]] Vec3i block_steps(Vec3d block_mm);

/// The part with its bores (of all that are given, those that touch it) and the letters in its top, as closed
/// and outward as snug/solid/solid.h says, from the origin into the positive octant, z upwards, in mm. No
/// booleans: the faces are triangulated around bores and letters.
[[nodiscard]] Solid part_solid(const PrintLayout& layout, int part, std::span<const Bore> bores,
                               Vec3d block_mm, const PrintOptions& options, PrintPose pose,
                               std::span<const SunkLetters> letters = {});

/// A loose dowel, lying: layers across a standing one would let it shear.
[[nodiscard]] Solid dowel_solid(const PrintOptions& options);

}  // namespace snug
