#pragma once

#include <string>

#include "snug/check/bearing.h"
#include "snug/design/design.h"
#include "snug/foam/notches.h"

namespace snug::cli {

/// Lines for people: where the notches are, and what the object lies on.
[[nodiscard]] Message notch_text(const Notch& notch);
/// `dropped`: drops are told elsewhere.
[[nodiscard]] Message bearing_text(const BearingReport& bearing, const Foams& foams, const Design& design,
                                   bool dropped);

}  // namespace snug::cli
