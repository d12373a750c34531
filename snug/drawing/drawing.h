#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "snug/base/color.h"
#include "snug/base/vec2.h"
#include "snug/words/words.h"

// One display list for everything that is drawn: maps on paper, outlines for a cutter, the preview on a
// screen. Written as SVG and DXF by the library and as PDF by what stands around it. Lengths in mm on the
// sheet: x to the right, y downward, (0, 0) the sheet's upper left corner. What is marked "screen" only
// pictures for the screen have: SVG shows it, paper and cutters go without.

namespace snug {

/// How a line looks on paper. A cutter follows its middle; it goes by the layer.
struct Pen {
    Color color;
    double width_mm = 0.2;
    std::vector<double> dashes_mm;  ///< drawn and left out in turn; empty: drawn through
    bool round_joins = false;       ///< screen
    bool round_ends = false;        ///< screen
    double opacity = 1;             ///< screen: 0 to 1
};

/// Where loops of one path overlap: filled where an odd number of them lies, or wherever their ways round do
/// not cancel (screen), so that a path may hold many polygons of one colour.
enum class FillRule { even_odd, nonzero };

// g++ 12 takes the path for read where a circle is put into the variant below.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

/// Straight lines through `points`.
struct PathItem {
    /// Several loops fill together. Open ones are not filled.
    std::vector<std::vector<Vec2d>> lines;
    bool closed = true;
    std::optional<Color> fill;
    std::optional<Pen> pen;
    FillRule rule = FillRule::even_odd;
    double fill_opacity = 1;  ///< screen: 0 to 1
};

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

struct CircleItem {
    Vec2d centre;
    double radius_mm = 0;
    std::optional<Color> fill;
    std::optional<Pen> pen;
    double fill_opacity = 1;  ///< screen: 0 to 1
};

enum class TextAnchor { start, middle, end };

/// Text that lies in a plane of space: where the drawing shows a step along the line that is read, and one
/// from the letters' heads to their feet.
struct TextPlane {
    Vec2d along{1, 0}, down{0, 1};
};

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
    std::string lead{};                ///< screen: bold words that stand before the text, with a space
    double spacing_mm = 0;             ///< screen: between letters
    double opacity = 1;                ///< screen: 0 to 1
    std::optional<Pen> halo{};         ///< screen: around the letters, beneath them
    std::optional<TextPlane> plane{};  ///< screen: instead of `turn_deg`
};

struct DrawingItem {
    int layer = 0;  ///< of Drawing::layers
    std::variant<PathItem, CircleItem, TextItem> what;
};

/// What belongs to one operation: "cut", "engrave", "notes". Letters, digits, - and _.
struct DrawingLayer {
    std::string name;
    Color color;  ///< by which cutters' programs tell operations apart
    /// Above 0 for a layer of thousands of small paths: SVG counts their corners in whole steps of this and
    /// keeps the text short. 0: every corner to 0.0001 mm.
    double step_mm = 0;
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
