#pragma once

#include <vector>

#include "snug/mesh/mesh.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

#include "tests/support/brute_force.h"
#include "tests/support/random.h"

namespace snug::test {

/// A random polygon soup in a random space, half of the time with every corner on a block face (in design
/// coordinates), so that ties are the rule.
struct RandomDesign {
    DesignSpace space;
    Mesh mesh;
    Placement placement;
    double clearance = 0;
    bool cut_on_touch = false;
    bool snapped = false;
};

[[nodiscard]] RandomDesign random_design(Random& random);

[[nodiscard]] std::vector<PlacedTriangle> placed_triangles(const Mesh& mesh, const Placement& placement);

}  // namespace snug::test
