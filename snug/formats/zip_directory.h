#pragma once

#include <vector>

#include "snug/formats/zip_read.h"

namespace snug {

/// The members that a zip's central directory lists; every offset and size lies within the file, and no two
/// members share bytes. Errors of kind `input`.
[[nodiscard]] Result<std::vector<ZipMember>> zip_directory(Bytes file);

}  // namespace snug
