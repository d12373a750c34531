#include "snug/drawing/page_builder.h"

#include <algorithm>
#include <utility>

#include "snug/drawing/svg.h"
#include "snug/drawing/text_lines.h"

namespace snug {
namespace {

std::vector<std::string> broken(std::string_view words, double width, const TextLook& look) {
    return lines_of(words, width, look.height_mm, look.bold);
}

}  // namespace

std::string piece_title(Piece piece) {
    if (piece.middle()) return "MIDDLE " + std::to_string(piece.index);
    return piece.highest() ? "LID" : "LOWER";
}
Color piece_color(Piece piece) {
    if (piece.middle()) return kMiddleGreen;
    return piece.highest() ? kUpperOrange : kLowerBlue;
}
Color piece_ink(Piece piece) {
    return mixed(piece_color(piece), {0, 0, 0}, piece.index == 0 ? 0.2 : 0.28);
}

std::string shortened(const std::string& words, double width_mm, const TextLook& look) {
    if (text_width(words, look.height_mm, look.bold) <= width_mm) return words;
    return lines_of(words, width_mm - look.height_mm, look.height_mm, look.bold).front() + "…";
}

PageBuilder::PageBuilder(std::string title, Vec2d size_mm, Language language) {
    drawing_.title = std::move(title);
    drawing_.size_mm = size_mm;
    drawing_.language = language;
    layer("notes", kInk);
}

void PageBuilder::layer(const std::string& name, Color color) {
    auto& layers = drawing_.layers;
    const auto found = std::find_if(layers.begin(), layers.end(),
                                    [&](const DrawingLayer& each) { return each.name == name; });
    layer_ = static_cast<int>(found - layers.begin());
    if (found == layers.end()) layers.push_back({name, color});
}

void PageBuilder::text(Vec2d baseline, std::string words, const TextLook& look, double turn_deg) {
    drawing_.items.push_back({layer_, TextItem{baseline, std::move(words), look.height_mm, look.anchor,
                                               turn_deg, look.bold, look.color}});
}

double PageBuilder::paragraph(Vec2d at, double width, std::string_view words, const TextLook& look) {
    double baseline = at.y + look.height_mm;
    for (std::string& line : broken(words, width, look)) {
        text({at.x, baseline}, std::move(line), look);
        baseline += look.height_mm * kLineSpacing;
    }
    return baseline - look.height_mm;
}

void PageBuilder::rectangle(Vec2d corner, Vec2d size, std::optional<Color> fill, std::optional<Pen> pen) {
    loops({{corner, corner + Vec2d{size.x, 0}, corner + size, corner + Vec2d{0, size.y}}}, fill,
          std::move(pen));
}

void PageBuilder::circle(Vec2d centre, double radius, std::optional<Color> fill, std::optional<Pen> pen) {
    drawing_.items.push_back({layer_, CircleItem{centre, radius, fill, std::move(pen)}});
}

void PageBuilder::lines(std::vector<std::vector<Vec2d>> lines, const Pen& pen) {
    drawing_.items.push_back({layer_, PathItem{std::move(lines), false, {}, pen}});
}

void PageBuilder::loops(std::vector<std::vector<Vec2d>> loops, std::optional<Color> fill,
                        std::optional<Pen> pen) {
    drawing_.items.push_back({layer_, PathItem{std::move(loops), true, fill, std::move(pen)}});
}

void PageBuilder::append(const std::vector<DrawingLayer>& layers, std::vector<DrawingItem> items) {
    std::vector<int> here;
    for (const DrawingLayer& each : layers) {
        layer(each.name, each.color);
        here.push_back(layer_);
    }
    for (DrawingItem& item : items) {
        item.layer = here[static_cast<std::size_t>(item.layer)];
        drawing_.items.push_back(std::move(item));
    }
}

PageFlow::PageFlow(Vec2d page_mm, const Message& title, const Message& subtitle, Color accent,
                   Language language)
    : page_mm_(page_mm),
      language_(language),
      title_(words(title)),
      subtitle_(words(subtitle)),
      accent_(accent) {
    begin_page();
}

void PageFlow::begin_page() {
    if (page_) done_.push_back(page_->finish());
    page_.emplace(title_, page_mm_, language_);
    y_ = kPageMargin;
    y_ = page_->paragraph({kPageMargin, y_}, width(), title_, {kTitleText, accent_, true}) - 1.5;
    y_ = page_->paragraph({kPageMargin, y_}, width(), subtitle_, {kBodyText, kSoftInk});
    rule();
}

bool PageFlow::need(double mm) {
    if (rest() >= mm) return false;
    begin_page();
    return true;
}

void PageFlow::heading(const Message& message) {
    need(kHeadingText * 3 + kBodyText * 2);
    y_ = page_->paragraph({kPageMargin, y_ + 2.4}, width(), words(message), {kHeadingText, kInk, true}) + 0.6;
}

void PageFlow::paragraph(const Message& message, const TextLook& look) {
    for (std::string& line : broken(words(message), width(), look)) {
        need(look.height_mm * kLineSpacing);
        page_->text({kPageMargin, y_ + look.height_mm}, std::move(line), look);
        y_ += look.height_mm * kLineSpacing;
    }
}

void PageFlow::item(const Message& mark, const Message& message, const TextLook& mark_look, double indent) {
    const std::vector<std::string> lines = broken(words(message), width() - indent, {});
    need(kBodyText * kLineSpacing * static_cast<double>(std::min<std::size_t>(lines.size(), 3)));
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (need(kBodyText * kLineSpacing) || i == 0)
            page_->text({kPageMargin, y_ + kBodyText}, mark, mark_look);
        page_->text({kPageMargin + indent, y_ + kBodyText}, lines[i]);
        y_ += kBodyText * kLineSpacing;
    }
    y_ += 1;
}

void PageFlow::steps(const std::vector<Message>& messages, double indent, Color numbers) {
    int step = 0;
    for (const Message& message : messages)
        item(as_it_is(std::to_string(++step)), message, {kBodyText, numbers, true}, indent);
}

void PageFlow::row(const std::vector<Message>& cells, const std::vector<double>& shares,
                   const TextLook& look) {
    need(look.height_mm * kLineSpacing);
    for (std::size_t i = 0; i < cells.size(); ++i)
        page_->text({kPageMargin + width() * shares[i], y_ + look.height_mm}, cells[i], look);
    y_ += look.height_mm * kLineSpacing;
}

void PageFlow::rule() {
    need(3);
    page_->line({kPageMargin, y_ + 1.2}, {page_mm_.x - kPageMargin, y_ + 1.2}, {kHairline, 0.2, {}});
    y_ += 3;
}

Vec2d PageFlow::room(double height_mm) {
    need(height_mm);
    const Vec2d corner{kPageMargin, y_};
    y_ += height_mm;
    return corner;
}

std::vector<Drawing> PageFlow::finish() {
    done_.push_back(page_->finish());
    page_.reset();
    return std::move(done_);
}

}  // namespace snug
