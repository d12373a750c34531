#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "snug/foam/design_space.h"
#include "snug/foam/prepared_surface.h"
#include "snug/mesh/mesh.h"

#include "bench/objects.h"
#include "bench/paper_method.h"

namespace snug::bench {

constexpr int kRotations = 20;

/// A cube in which every object turns freely, cut into `layers` along x and `columns` along y and z.
[[nodiscard]] DesignSpace space_of(int columns, int layers);

/// An object from its placement to two foams by each method, by turns a few rotations at a time, so that
/// each finds its own data in the caches, as it would under a slider or in a search.
struct Contest {
    const Mesh& mesh;
    const PreparedSurface& prepared;
    PaperMethod* paper;  ///< null: without it

    /// The methods' times (paper, loop, snug, threads) over kRotations random rotations, the paper's over
    /// the first `paper_rotations` of every turn; with what the paper's textures miss and add, as shares of
    /// the blocks that must be cut. Ends the program where Snug's foams differ from the plain loop's.
    [[nodiscard]] nlohmann::json run(const DesignSpace& space, int paper_rotations) const;
};

}  // namespace snug::bench
