#pragma once

#include "snug/base/message.h"
#include "snug/check/protection_report.h"

namespace snug {

/// "kept off by 15 mm, 1,855 blocks cut for it; 4 mm stay free from a drop on its back", "pressed with up
/// to 1.2 kPa of the 2 that it bears"
[[nodiscard]] Message zone_text(const ZoneReport& zone);

}  // namespace snug
