#pragma once

#include <optional>
#include <string>

#include "snug/base/vec.h"

namespace snug {

/// What holds the parts of a half together that is larger than the bed.
enum class PrintJoint { none, dowels };

struct PrintOptions {
    Vec3d bed_mm{250, 210, 210};  ///< of the printer: to the right, to the back, upwards; 10 to 2000
    PrintJoint joint = PrintJoint::dowels;
    double dowel_diameter_mm = 6;      ///< 1 to 100
    double dowel_length_mm = 24;       ///< from its diameter to 1000
    double joint_clearance_mm = 0.15;  ///< left around a dowel on every side, 0 to 5
    bool rigid = true;                 ///< the material holds, but does not cushion
    friend bool operator==(const PrintOptions&, const PrintOptions&) = default;
};

/// What is out of range, as a sentence; none where all is well.
[[nodiscard]] std::optional<std::string> problem_of(const PrintOptions& options);

}  // namespace snug
