#pragma once

#include "snug/base/message.h"

namespace snug::cli {

/// Why the system refused, by its error number: "Permission denied".
[[nodiscard]] Message reason(int error);

/// "cannot be read (Permission denied)"
[[nodiscard]] Message cannot_be_read(int error);

}  // namespace snug::cli
