#include "snug/fabricate/sheets/sheet_drawing.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace snug {
namespace {

using Lines = std::vector<std::vector<Vec2d>>;

constexpr double kLineWidth = 0.1;  // mm
enum Layer { kEngrave, kMark, kInner, kOuter };

const std::vector<DrawingLayer>& layers() {
    static const std::vector<DrawingLayer> all{{"engrave", {0, 150, 0}},
                                               {"mark", {0, 170, 200}},
                                               {"cut-inner", {0, 0, 255}},
                                               {"cut-outer", {255, 0, 0}}};
    return all;
}

Pen pen(Layer layer) {
    return {layers()[static_cast<std::size_t>(layer)].color, kLineWidth, {}};
}

void add_lines(Drawing& drawing, Layer layer, const Lines& lines, Vec2d corner, bool closed) {
    if (lines.empty()) return;
    Lines moved = lines;
    for (auto& line : moved)
        for (Vec2d& p : line) p = p + corner;
    drawing.items.push_back({layer, PathItem{std::move(moved), closed, {}, pen(layer)}});
}

void add_cuts(Drawing& drawing, const CutPiece& piece, const PiecePlace& place) {
    for (CircleItem circle : piece.circles) {
        circle.centre = circle.centre + place.corner;
        circle.pen = pen(kInner);
        drawing.items.push_back({kInner, circle});
    }
    add_lines(drawing, kInner, piece.inner, place.corner, true);
    add_lines(drawing, place.host >= 0 ? kInner : kOuter, {piece.outer}, place.corner, true);
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
    drawing.layers = layers();
    const std::vector<std::size_t> order = in_cutting_order(pieces, nesting, stock);
    for (const std::size_t i : order) {
        add_lines(drawing, kEngrave, pieces[i].engraved, nesting.places[i].corner, false);
        add_lines(drawing, kMark, pieces[i].marked, nesting.places[i].corner, false);
    }
    for (const std::size_t i : order) add_cuts(drawing, pieces[i], nesting.places[i]);
    std::stable_sort(drawing.items.begin(), drawing.items.end(),
                     [](const DrawingItem& a, const DrawingItem& b) { return a.layer < b.layer; });
    return drawing;
}

}  // namespace snug
