#include "snug/design/mill_options.h"

namespace snug {

double wanted_step_down_mm(const MillOptions& options) {
    return options.step_down_mm.value_or(options.cutter_mm / 2);
}

}  // namespace snug
