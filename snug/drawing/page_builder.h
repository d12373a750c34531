#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/half.h"
#include "snug/base/result.h"
#include "snug/drawing/drawing.h"

// How every page for the workshop looks, and short words to draw it with. Lengths in mm of the page.

namespace snug {

// One scale of type: the height of the font.
constexpr double kTitleText = 8;
constexpr double kHeadingText = 4.6;
constexpr double kBodyText = 3.5;
constexpr double kSmallText = 2.7;
constexpr double kLineSpacing = 1.42;  // of the height
constexpr double kPageMargin = 15;

constexpr Color kInk{28, 36, 46}, kSoftInk{96, 106, 120}, kHairline{196, 202, 210}, kPaper{255, 255, 255};
constexpr Color kAlarm{186, 40, 40};

[[nodiscard]] std::string_view half_title(Half half);  ///< LOWER or LID
[[nodiscard]] Color half_color(Half half);
/// Dark enough for letters on white.
[[nodiscard]] Color half_ink(Half half);

struct TextLook {
    double height_mm = kBodyText;
    Color color = kInk;
    bool bold = false;
    TextAnchor anchor = TextAnchor::start;
};

/// The text, or as much of its beginning as fits the width, with an ellipsis.
[[nodiscard]] std::string shortened(const std::string& words, double width_mm, const TextLook& look);

class PageBuilder {
  public:
    PageBuilder(std::string title, Vec2d size_mm);

    /// Later items belong to this layer; one of that name is made where there is none.
    void layer(const std::string& name, Color color);

    void text(Vec2d baseline, std::string words, const TextLook& look = {}, double turn_deg = 0);
    /// Lines no wider than `width`, the first with its top at `at`; gives where the next may begin.
    double paragraph(Vec2d at, double width, std::string_view words, const TextLook& look = {});
    void rectangle(Vec2d corner, Vec2d size, std::optional<Color> fill, std::optional<Pen> pen = {});
    void lines(std::vector<std::vector<Vec2d>> lines, const Pen& pen);
    void line(Vec2d from, Vec2d to, const Pen& pen) { lines({{from, to}}, pen); }
    void loops(std::vector<std::vector<Vec2d>> loops, std::optional<Color> fill, std::optional<Pen> pen = {});

    /// Items of another drawing with their layers, which join those of the same name.
    void append(const std::vector<DrawingLayer>& layers, std::vector<DrawingItem> items);

    [[nodiscard]] Drawing finish() { return std::move(drawing_); }

  private:
    Drawing drawing_;
    int layer_ = 0;
};

/// Writes from top to bottom and begins a new page where one is full.
class PageFlow {
  public:
    /// Every page begins with `title` in the title's size and `subtitle` below.
    PageFlow(Vec2d page_mm, std::string title, std::string subtitle, Color accent);

    void heading(std::string_view words);
    void paragraph(std::string_view words, const TextLook& look = {});
    /// A paragraph behind a number, a word or a dash, which stands again where a page breaks the paragraph.
    void item(std::string_view mark, std::string_view words, const TextLook& mark_look, double indent);
    /// Cells in columns that begin at these shares of the width.
    void row(const std::vector<std::string>& cells, const std::vector<double>& shares, const TextLook& look);
    void rule();
    void space(double mm) { y_ += mm; }
    /// Room for a picture of this height; gives its upper left corner.
    [[nodiscard]] Vec2d room(double height_mm);

    [[nodiscard]] PageBuilder& page() { return *page_; }
    [[nodiscard]] double width() const { return page_mm_.x - 2 * kPageMargin; }
    [[nodiscard]] double rest() const { return page_mm_.y - kPageMargin - y_; }
    [[nodiscard]] std::vector<Drawing> finish();

  private:
    void begin_page();
    /// Begins a page where less than this is left; true if it did.
    bool need(double mm);

    Vec2d page_mm_;
    std::string title_, subtitle_;
    Color accent_;
    double y_ = 0;
    std::optional<PageBuilder> page_;
    std::vector<Drawing> done_;
};

}  // namespace snug
