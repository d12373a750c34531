#pragma once

#include <string>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/print_options.h"
#include "snug/fabricate/mould/mould_form.h"
#include "snug/solid/solid.h"

namespace snug {

/// One printed part of a mould.
struct MouldPart {
    Solid solid;    ///< as it is printed: from the origin into the positive octant, z upwards
    Vec3d at_mm;    ///< its least corner in the assembled mould, which stands from the origin on, z upwards
    Vec3d size_mm;  ///< in the assembled mould
    bool turned = false;  ///< printed turned by a quarter, counter-clockwise as seen from above
};

struct MouldedHalf {
    std::vector<MouldPart> parts;
    int bores = 0;
    int without_joint = 0;         ///< pairs of parts that meet without a dowel
    double plastic_mm3 = 0;        ///< of all parts, printed solid
    double pour_mm3 = 0;           ///< up to the pour level
    long long lost_blocks = 0;     ///< of the half, where faces that lean leave no room between them
    bool upright_at_cuts = false;  ///< a face of the core lies in a cut, where faces do not lean
};

/// A mould to print and what it came to.
struct Mould {
    MouldForm form;
    MouldedHalf made;
    std::vector<std::string> names;  ///< of its parts, as their files are called
};

/// The form with leaning faces, cut apart for the bed and joined by dowels. Faces lean by `draft_deg` below
/// the pour level so that the foam is narrower towards its cavity; they stay upright on the outside and in
/// cuts. Fails (kind usage) for a bed that one block with its walls does not fit on, or too many parts.
[[nodiscard]] Result<MouldedHalf> mould_parts(const MouldForm& form, double draft_deg,
                                              const PrintOptions& print);

}  // namespace snug
