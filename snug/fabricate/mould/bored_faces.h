#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "snug/fabricate/printing/bores.h"
#include "snug/polygon/polygon_with_holes.h"
#include "snug/solid/step_solid.h"

namespace snug {

/// A side of a solid's box: across an axis, the least one or the greatest. Of axis 0 the base and the top.
struct BoredSide {
    int axis = 0;
    bool low = false;
    friend auto operator<=>(const BoredSide&, const BoredSide&) = default;
};

/// A blind bore into a face that lies on a side of the box, in steps; its opening lies within that face.
struct SlabBore {
    BoredSide side;
    int depth = 0;               ///< into the solid
    std::vector<Vec3i> opening;  ///< four corners, as BoreVertices says
    std::vector<Vec3i> mouth;    ///< kBoreSides corners
};

/// The bore of a dowel in a part whose first corner stands at `from_mm`; `plane`: where the part's face lies
/// along the bore's axis, in steps from there. `after`: the part begins at the cut.
[[nodiscard]] SlabBore slab_bore(const Bore& bore, bool after, Vec3d from_mm, int plane,
                                 const PrintOptions& options);

/// Collects the outlines of the faces that have bores, and triangulates them around the bores.
class BoredFaces {
  public:
    explicit BoredFaces(std::span<const SlabBore> bores) : bores_(bores) {}

    [[nodiscard]] bool has(BoredSide side) const;
    /// A piece of a face's outline, counter-clockwise from outside. What runs both ways lies between pieces
    /// of one face.
    void add_edges(BoredSide side, const std::vector<std::uint32_t>& chain);
    /// The faces, and the walls and ends of their bores.
    void add_to(StepSolid& solid) const;

  private:
    using Edge = std::pair<std::uint32_t, std::uint32_t>;

    std::span<const SlabBore> bores_;
    std::map<BoredSide, std::vector<Edge>> edges_;
};

}  // namespace snug
