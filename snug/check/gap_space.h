#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "snug/base/box.h"
#include "snug/base/vec.h"
#include "snug/check/line_lattice.h"
#include "snug/check/prism_field.h"
#include "snug/foam/block_map.h"
#include "snug/mesh/triangle_tree.h"
#include "snug/space/design_space.h"

namespace snug {

/// The cut runs of a block map as prisms, within the rectangle of columns that have any.
[[nodiscard]] PrismField cut_field(const BlockMap& blocks, const DesignSpace& space);

/// The cut-away space without the object, as a set that can be asked how far a point lies from its border:
/// foam, whatever lies outside the design space, the object's surface and, on its inner side, the object. The
/// inside is where the winding number is not 0 or, where `hull` is given, that hull. Keeps views of
/// everything it is made from.
class GapSpace {
  public:
    GapSpace(const PrismField& cut, const TriangleTree& surface, std::span<const Vec3d> vertices,
             const LineLattice& lattice, const PrismField* hull);

    /// What is known of the surface around a point: it has no part nearer than `clear`, and the point lies
    /// inside the object or not.
    struct Surroundings {
        Vec3d centre;
        double clear = 0;
        bool inside = false;
    };

    /// What a point says about balls around it and nearby.
    struct Probe {
        double room = 0;  ///< radius of the largest ball around the point; not above 0 outside the gap. A
                          ///< function of the point whose slope never exceeds 1. Not above what was called
                          ///< enough it may be less: then this is an upper bound
        Surroundings surroundings;
        std::array<Vec3d, 4> obstacles;  ///< points that no ball in the gap contains
        int obstacle_count = 0;
        std::uint32_t work = 0;  ///< boxes, prisms and triangles that were looked at
    };

    /// `radius`: how far around p the caller is interested; deeper inside the object than that is all the
    /// same to it. `enough`: a room not above this is all the same to it, too. `known`: of a point nearby.
    [[nodiscard]] Probe probe(Vec3d p, double radius, double enough, const Surroundings& known) const;

  private:
    [[nodiscard]] bool inside_object(Vec3d p, std::uint32_t& work) const;
    void limit_by_foam(Probe& probe, Vec3d p) const;
    void limit_by_hull(Probe& probe, Vec3d p, double radius) const;
    void limit_by_surface(Probe& probe, Vec3d p, double radius, double enough,
                          const Surroundings& known) const;

    const PrismField& cut_;
    const TriangleTree& surface_;
    std::span<const Vec3d> vertices_;
    const LineLattice& lattice_;
    const PrismField* hull_;
};

}  // namespace snug
