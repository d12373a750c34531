#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "snug/base/box.h"
#include "snug/base/rotation.h"
#include "snug/base/vec.h"
#include "snug/formats/triangle_stream.h"
#include "snug/mesh/shell.h"

// Triangles of a stream that are looked at together: scanners write neighbours one after the other, so a box
// around a few tells most often that none of them changes anything.

namespace snug {

/// How a file's coordinates become the object's: relative to an origin and in mm, rounded as a mesh in memory
/// has them.
struct FileToObject {
    Vec3d origin;
    double factor = 1;

    [[nodiscard]] Vec3f operator()(Vec3f p) const {
        if (!(origin == Vec3d{})) p = vec_cast<float>(vec_cast<double>(p) - origin);
        return factor == 1 ? p : vec_cast<float>(vec_cast<double>(p) * factor);
    }
};

using TriangleGroup = std::span<const TriangleStream::Corners>;

/// Calls visit(group) for the groups of a piece.
template <class Visit>
void for_groups(TriangleGroup piece, const Visit& visit) {
    constexpr std::size_t kGroup = 64;
    for (std::size_t at = 0; at < piece.size(); at += kGroup)
        visit(piece.subspan(at, std::min(kGroup, piece.size() - at)));
}

/// The box of coordinates as the file has them.
[[nodiscard]] Box3d box_of(TriangleGroup group);

/// Of a box of floats. Rounding keeps the order of numbers, so the result holds every corner of the group as
/// the object has it.
[[nodiscard]] Box3d in_object(const FileToObject& object, const Box3d& box);

/// What a box may reach once it is turned and shifted, with all that rounding does.
[[nodiscard]] Box3d reached(const Rotation& rotation, Vec3d shift, const Box3d& box);

/// Marks the cubes that the group meets, by halves until each lies within a few. `box` is the group's, in the
/// object's coordinates.
void mark_group(MetCubes& cubes, const FileToObject& object, TriangleGroup group, const Box3d& box);

}  // namespace snug
