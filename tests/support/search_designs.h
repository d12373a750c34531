#pragma once

#include "snug/design/design.h"
#include "snug/mesh/mesh.h"
#include "snug/search/turn.h"
#include "snug/space/design_space.h"

#include "tests/support/random.h"

namespace snug::test {

/// The mesh turned, so that nothing about its rotation is left in its coordinates.
[[nodiscard]] inline Mesh turned(Mesh mesh, const Turn& turn) {
    const Rotation rotation = rotation_of(turn);
    for (Vec3f& v : mesh.vertices) v = vec_cast<float>(rotation(vec_cast<double>(v)));
    return mesh;
}

[[nodiscard]] inline Turn random_turn(Random& random) {
    return spread_turn(random.bits() % 100000, random.bits());
}

/// Blocks that the object, turned any way, fits into with room around it.
[[nodiscard]] inline Design roomy_design(const Mesh& mesh, Vec3d block_mm) {
    Design design;
    const Vec3d size = bounds(mesh).size();
    Vec3i blocks;
    for (int axis = 0; axis < 3; ++axis)
        blocks[axis] = 4 + static_cast<int>((size.x + size.y + size.z) / block_mm[axis]);
    design.space.blocks = blocks;
    design.space.block_mm = block_mm;
    design.object.units = Unit::mm;
    return design;
}

[[nodiscard]] inline DesignSpace space_of(const Design& design) {
    return {*design.space.blocks, design.space.block_mm};
}

}  // namespace snug::test
