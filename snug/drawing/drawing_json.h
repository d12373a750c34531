#pragma once

#include <string>

#include "snug/drawing/drawing.h"

namespace snug {

/// The pages of a document as JSON, for a writer in another language. Lengths in mm with four decimals:
/// [{title, size: [w, h], items: [...]}], each item one of
///   {path: [[x, y, x, y, ...], ...], closed, fill, pen}
///   {circle: [x, y, radius], fill, pen}
///   {text, at: [x, y], height, anchor: "start"|"middle"|"end", turn, bold, color}
/// with colours as "#rrggbb", pens as {color, width, dashes}, and null for what is not there.
[[nodiscard]] std::string drawing_json(const DrawingDocument& document);

}  // namespace snug
