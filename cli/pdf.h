#pragma once

#include <cstddef>
#include <vector>

#include "snug/base/result.h"
#include "snug/drawing/drawing.h"

namespace snug::cli {

/// The document as PDF, a page a drawing, asking the viewer not to scale it where it must keep its true size.
/// Letters that Western Latin (Windows-1252) lacks become question marks. Fails with kind `usage` for a page
/// that PDF cannot hold (longer than 5 m), with kind `output` where the file cannot be made.
[[nodiscard]] Result<std::vector<std::byte>> write_pdf(const DrawingDocument& document);

}  // namespace snug::cli
