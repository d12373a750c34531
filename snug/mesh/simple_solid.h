#pragma once

#include <string_view>

#include "snug/base/names.h"
#include "snug/mesh/mesh.h"

namespace snug {

enum class SolidKind { box, cylinder, cone, ball };
template <>
struct Names<SolidKind> {
    static constexpr std::string_view list[] = {"box", "cylinder", "cone", "ball"};
};

/// What can be measured with a ruler: mm, about its centre.
struct SimpleSolid {
    SolidKind kind = SolidKind::box;
    Vec3d size_mm;         ///< along x, y and z before it is turned; of a cylinder, cone or ball the two
                           ///< diameters are equal, and its axis is z
    double radius_mm = 0;  ///< of a box's edges; at most half of its shortest side
    double top_mm = 0;     ///< of a cone, its diameter at the end of the axis; 0: a tip
    char along = 'z';      ///< of a cylinder or cone, where its axis points to: x, y or z
    Vec3d turn_deg;        ///< psi, theta, phi, after that
    Vec3d centre_mm;       ///< where it stands at last
    friend bool operator==(const SimpleSolid&, const SimpleSolid&) = default;
};

/// Appends its surface, closed and outward, without any degenerate triangle. Curves are drawn by chords that
/// lie within 0.02 mm of them, but by no more than 512 around an axis and 128 around what is round both ways.
void add_solid(Mesh& mesh, const SimpleSolid& solid);

}  // namespace snug
