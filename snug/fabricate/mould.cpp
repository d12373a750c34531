#include "snug/fabricate/mould.h"

namespace snug {

Result<WorkshopPack> mould_pack(const FoamDesign&, const MouldOptions&, const PrintOptions&) {
    return fail(ErrorKind::usage, "there is no pack for moulds yet");
}

}  // namespace snug
