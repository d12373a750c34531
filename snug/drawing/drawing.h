#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "snug/base/color.h"
#include "snug/base/vec2.h"
#include "snug/words/words.h"

// One display list for everything that is drawn for the workshop: maps on paper, outlines for a cutter.
// Written as SVG and DXF by the library and as PDF by what stands around it. Lengths in mm on the sheet: x to
// the right, y downward, (0, 0) the sheet's upper left corner.

namespace snug {

/// How a line looks on paper. A cutter follows its middle; it goes by the layer.
struct Pen {
    Color color;
    double width_mm = 0.2;
    std::vector<double> dashes_mm;  ///< drawn and left out in turn; empty: drawn through
};

/// Straight lines through `points`.
struct PathItem {
    /// Several loops fill together by the even-odd rule. Open ones are not filled.
    std::vector<std::vector<Vec2d>> lines;
    bool closed = true;
    std::optional<Color> fill;
    std::optional<Pen> pen;
};

struct CircleItem {
    Vec2d centre;
    double radius_mm = 0;
    std::optional<Color> fill;
    std::optional<Pen> pen;
};

enum class TextAnchor { start, middle, end };

/// One line of text (UTF-8), for readers only: cutters leave text out, see stroke_text.h for what they
/// engrave.
struct TextItem {
    Vec2d at;  ///< of the baseline, where the anchor says
    std::string text;
    double height_mm = 3;  ///< of the font (a capital is about 0.7 of it)
    TextAnchor anchor = TextAnchor::start;
    double turn_deg = 0;  ///< clockwise as seen by the reader: 0, 90, 180 or 270
    bool bold = false;
    Color color;
};

struct DrawingItem {
    int layer = 0;  ///< of Drawing::layers
    std::variant<PathItem, CircleItem, TextItem> what;
};

/// What belongs to one operation: "cut", "engrave", "notes". Letters, digits, - and _.
struct DrawingLayer {
    std::string name;
    Color color;  ///< by which cutters' programs tell operations apart
};

/// One sheet of paper or stock; later items lie above earlier ones.
struct Drawing {
    std::string title;
    Vec2d size_mm;
    std::vector<DrawingLayer> layers;
    std::vector<DrawingItem> items;
    Language language = Language::english;  ///< of its texts
};

/// Pages that belong together in one file, in their order.
struct DrawingDocument {
    std::string name;  ///< of the file, without its ending
    std::string title;
    std::vector<Drawing> pages;
    bool true_size = true;  ///< must be printed at 100 %
};

}  // namespace snug
