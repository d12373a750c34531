#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/piece.h"
#include "snug/base/result.h"
#include "snug/drawing/drawing.h"
#include "snug/words/words.h"

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

/// What is written on a piece: LOWER, MIDDLE 1 or LID.
[[nodiscard]] std::string piece_title(Piece piece);
[[nodiscard]] Color piece_color(Piece piece);
/// Dark enough for letters on white.
[[nodiscard]] Color piece_ink(Piece piece);

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
    PageBuilder(std::string title, Vec2d size_mm, Language language = Language::english);

    /// A message in the page's language.
    [[nodiscard]] std::string words(const Message& message) const {
        return snug::text(message, drawing_.language);
    }

    /// Later items belong to this layer; one of that name is made where there is none.
    void layer(const std::string& name, Color color);

    void text(Vec2d baseline, std::string words, const TextLook& look = {}, double turn_deg = 0);
    void text(Vec2d baseline, const Message& message, const TextLook& look = {}, double turn_deg = 0) {
        text(baseline, words(message), look, turn_deg);
    }
    /// Lines no wider than `width`, the first with its top at `at`; gives where the next may begin.
    double paragraph(Vec2d at, double width, std::string_view words, const TextLook& look = {});
    void rectangle(Vec2d corner, Vec2d size, std::optional<Color> fill, std::optional<Pen> pen = {});
    void circle(Vec2d centre, double radius, std::optional<Color> fill, std::optional<Pen> pen = {});
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

/// Writes from top to bottom and begins a new page where one is full. Names, numbers and the like are
/// messages as_it_is().
class PageFlow {
  public:
    /// Every page begins with `title` in the title's size and `subtitle` below.
    PageFlow(Vec2d page_mm, const Message& title, const Message& subtitle, Color accent, Language language);

    void heading(const Message& message);
    void paragraph(const Message& message, const TextLook& look = {});
    /// A paragraph behind a number, a word or a dash, which stands again where a page breaks the paragraph.
    void item(const Message& mark, const Message& message, const TextLook& mark_look, double indent);
    /// Items behind 1, 2, 3, ...
    void steps(const std::vector<Message>& messages, double indent, Color numbers = kSoftInk);
    /// Cells in columns that begin at these shares of the width.
    void row(const std::vector<Message>& cells, const std::vector<double>& shares, const TextLook& look);
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

    [[nodiscard]] std::string words(const Message& message) const { return text(message, language_); }

    Vec2d page_mm_;
    Language language_;
    std::string title_, subtitle_;
    Color accent_;
    double y_ = 0;
    std::optional<PageBuilder> page_;
    std::vector<Drawing> done_;
};

}  // namespace snug
