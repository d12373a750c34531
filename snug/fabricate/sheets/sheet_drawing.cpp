#include "snug/fabricate/sheets/sheet_drawing.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace snug {
namespace {

using Lines = std::vector<std::vector<Vec2d>>;

constexpr double kLineWidth = 0.1;  // mm

/// What is done to the foam, in the order of work.
class SheetLayers {
  public:
    explicit SheetLayers(bool slits) {
        layers_ = {{"engrave", {0, 150, 0}}, {"mark", {0, 170, 200}}};
        if (slits) layers_.push_back({kSlitLayer, {170, 0, 200}});
        layers_.push_back({"cut-inner", {0, 0, 255}});
        layers_.push_back({"cut-outer", {255, 0, 0}});
    }
    [[nodiscard]] const std::vector<DrawingLayer>& all() const { return layers_; }
    [[nodiscard]] int engrave() const { return 0; }
    [[nodiscard]] int mark() const { return 1; }
    [[nodiscard]] int slit() const { return 2; }
    [[nodiscard]] int inner() const { return static_cast<int>(layers_.size()) - 2; }
    [[nodiscard]] int outer() const { return static_cast<int>(layers_.size()) - 1; }
    [[nodiscard]] Pen pen(int layer) const {
        return {layers_[static_cast<std::size_t>(layer)].color, kLineWidth, {}};
    }

  private:
    std::vector<DrawingLayer> layers_;
};

void add_lines(Drawing& drawing, const SheetLayers& layers, int layer, const Lines& lines, Vec2d corner,
               bool closed = false) {
    if (lines.empty()) return;
    Lines moved = lines;
    for (auto& line : moved)
        for (Vec2d& p : line) p = p + corner;
    drawing.items.push_back({layer, PathItem{std::move(moved), closed, {}, layers.pen(layer)}});
}

void add_cuts(Drawing& drawing, const SheetLayers& layers, const CutPiece& piece, const PiecePlace& place) {
    for (CircleItem circle : piece.circles) {
        circle.centre = circle.centre + place.corner;
        circle.pen = layers.pen(layers.inner());
        drawing.items.push_back({layers.inner(), circle});
    }
    add_lines(drawing, layers, layers.inner(), piece.inner, place.corner, true);
    add_lines(drawing, layers, place.host >= 0 ? layers.inner() : layers.outer(), {piece.outer}, place.corner,
              true);
}

double area(const CutPiece& piece) {
    Vec2d low = piece.outer.front(), high = low;
    for (const Vec2d p : piece.outer) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return (high.x - low.x) * (high.y - low.y);
}

/// The pieces on one sheet of stock, smallest first.
std::vector<std::size_t> in_cutting_order(std::span<const CutPiece> pieces, const Nesting& nesting,
                                          int stock) {
    std::vector<std::pair<double, std::size_t>> sized;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (nesting.places[i].stock == stock) sized.push_back({area(pieces[i]), i});
    std::sort(sized.begin(), sized.end());
    std::vector<std::size_t> order;
    for (const auto& piece : sized) order.push_back(piece.second);
    return order;
}

}  // namespace

Drawing stock_drawing(std::span<const CutPiece> pieces, const Nesting& nesting, int stock,
                      const Message& title, Language language) {
    Drawing drawing;
    drawing.title = text(title, language);
    drawing.language = language;
    drawing.size_mm = nesting.stock_mm;
    const std::vector<std::size_t> order = in_cutting_order(pieces, nesting, stock);
    const SheetLayers layers(
        std::any_of(order.begin(), order.end(), [&](std::size_t i) { return !pieces[i].slit.empty(); }));
    drawing.layers = layers.all();
    for (const std::size_t i : order) {
        const Vec2d corner = nesting.places[i].corner;
        add_lines(drawing, layers, layers.engrave(), pieces[i].engraved, corner);
        add_lines(drawing, layers, layers.mark(), pieces[i].marked, corner);
        add_lines(drawing, layers, layers.slit(), pieces[i].slit, corner);
    }
    for (const std::size_t i : order) add_cuts(drawing, layers, pieces[i], nesting.places[i]);
    std::stable_sort(drawing.items.begin(), drawing.items.end(),
                     [](const DrawingItem& a, const DrawingItem& b) { return a.layer < b.layer; });
    return drawing;
}

}  // namespace snug
