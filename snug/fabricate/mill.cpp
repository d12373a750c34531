#include "snug/fabricate/mill.h"

namespace snug {

Result<WorkshopPack> mill_pack(const FoamDesign&, const std::optional<MilledObject>&, const MillOptions&) {
    return fail(ErrorKind::usage, "there is no pack for the mill yet");
}

}  // namespace snug
