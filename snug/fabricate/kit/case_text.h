#pragma once

#include "snug/base/message.h"
#include "snug/space/case_space.h"

namespace snug {

/// "a box: 425 x 284 x 155 mm inside, 2 mm of play on each side, lid 45 mm"
[[nodiscard]] Message case_text(const CaseSpace& fitted);
/// "left, lid: 410 x 278 x 12 mm"
[[nodiscard]] Message filler_text(const Filler& filler);

}  // namespace snug
