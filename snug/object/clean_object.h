#pragma once

#include <vector>

#include "snug/base/finding.h"
#include "snug/base/result.h"
#include "snug/design/clean_options.h"
#include "snug/mesh/clean.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// What was taken away from an object before anything else happened to it.
struct CleanReport {
    std::vector<PartShare> parts;  ///< of the object as it was read; none where no part was to be dropped
    std::vector<PartShare> dropped;
    double smallest_mm = 0;  ///< longest side of the smallest part, where parts were to be dropped
    bool plane_cut = false;  ///< something lay behind the plane
    /// Where the object lies along the direction of a plane that met nothing, mm from the file's origin.
    double nearest_mm = 0, farthest_mm = 0;
};

/// A mesh in mm without what the options drop: first parts, then what lies behind the plane. Fails with kind
/// `usage` where a part is named that is not there, where nothing would be left, and for parts of a cloud.
struct Cleaned {
    Mesh mesh;
    CleanReport report;
};
[[nodiscard]] Result<Cleaned> cleaned(Mesh mesh, const CleanOptions& options);

/// `dropped` and `cut_off` (notes): nothing is left out unsaid. What was asked for and did nothing is said,
/// too: `nothing_dropped` (note) and `cut_missed` (warning).
void find_dropped(const CleanReport& report, const CleanOptions& asked, std::vector<Finding>& findings);

}  // namespace snug
