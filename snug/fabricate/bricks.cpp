#include "snug/fabricate/bricks.h"

namespace snug {

Result<WorkshopPack> brick_pack(const FoamDesign&, const WorkshopOptions&, const LpSolver&, const Progress&) {
    return fail(ErrorKind::usage, "there is no pack for bricks yet");
}

}  // namespace snug
