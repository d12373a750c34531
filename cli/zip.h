#pragma once

#include "snug/base/result.h"
#include "snug/fabricate/kit/workshop_pack.h"

namespace snug::cli {

/// The container as a zip file: its members in their order, each with the oldest time that zip knows, so
/// that equal members make equal archives. Fails with kind `output`.
[[nodiscard]] Result<FileBytes> write_zip(const PackContainer& container);

}  // namespace snug::cli
