#pragma once

#include <vector>

#include "snug/base/result.h"
#include "snug/design/clean_options.h"
#include "snug/foam/finding.h"
#include "snug/mesh/clean.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// What was taken away from an object before anything else happened to it.
struct CleanReport {
    std::vector<PartShare> parts;  ///< of the object as it was read; none where no part was to be dropped
    std::vector<PartShare> dropped;
    bool plane_cut = false;  ///< something lay behind the plane
};

/// A mesh in mm without what the options drop: first parts, then what lies behind the plane. Fails with kind
/// `usage` where a part is named that is not there, where nothing would be left, and for parts of a cloud.
struct Cleaned {
    Mesh mesh;
    CleanReport report;
};
[[nodiscard]] Result<Cleaned> cleaned(Mesh mesh, const CleanOptions& options);

/// `dropped` and `cut_off` (notes): nothing is left out unsaid.
void find_dropped(const CleanReport& report, std::vector<Finding>& findings);

}  // namespace snug
