#include "snug/fabricate/sheets/sheet_engraving.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "snug/drawing/stroke_text.h"

namespace snug {
namespace {

using Lines = std::vector<std::vector<Vec2d>>;

constexpr double kAround = 1.5;                                         // mm of foam around letters
constexpr std::array<double, 7> kHeights{14, 10, 8, 6, 4.5, 3.5, 2.5};  // mm, the first that fits
constexpr double kOddCorner = 10;                                       // mm, its two short sides

struct Extent {
    Vec2d low{1e9, 1e9}, high{-1e9, -1e9};
};

Extent extent(const Lines& lines) {
    Extent found;
    for (const auto& line : lines) {
        for (const Vec2d p : line) {
            found.low = {std::min(found.low.x, p.x), std::min(found.low.y, p.y)};
            found.high = {std::max(found.high.x, p.x), std::max(found.high.y, p.y)};
        }
    }
    return found;
}

void append(Lines& lines, Lines more) {
    for (auto& line : more) lines.push_back(std::move(line));
}

void move(Lines& lines, Vec2d by) {
    for (auto& line : lines)
        for (Vec2d& p : line) p = p + by;
}

/// Words and, if wished, an arrow to BACK behind them.
Lines label(Half half, const std::string& words, double height, bool arrow) {
    Lines lines = stroke_text(words, {0, 0}, height, TextAnchor::start, 0);
    if (arrow) {
        const Extent box = extent(lines);
        append(lines, back_arrow(half, {box.high.x + 0.45 * height, box.high.y}, box.high.y - box.low.y));
    }
    return lines;
}

/// Cells of a piece on which letters may stand.
class FreeCells {
  public:
    FreeCells(const SheetStack& stack, const SheetPiece& piece) : cell_(stack.cell_mm), free_(piece.mask) {}

    /// Takes the cells that the rectangle meets.
    void take(Vec2d low, Vec2d high) {
        const int first_column = std::max(0, static_cast<int>(std::floor(low.x / cell_.x)));
        const int first_row = std::max(0, static_cast<int>(std::floor(low.y / cell_.y)));
        for (int row = first_row; row < free_.height && row * cell_.y < high.y; ++row)
            for (int column = first_column; column < free_.width && column * cell_.x < high.x; ++column)
                free_.cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(free_.width) +
                            static_cast<std::size_t>(column)] = 0;
    }

    /// The middle of the first block of free cells, row by row, that holds a box of this size.
    [[nodiscard]] std::optional<Vec2d> room_for(Vec2d size) const {
        const int columns = static_cast<int>(std::ceil(size.x / cell_.x));
        const int rows = static_cast<int>(std::ceil(size.y / cell_.y));
        if (columns > free_.width || rows > free_.height) return {};
        std::vector<int> tall(static_cast<std::size_t>(free_.width), 0);  // free cells upward from this row
        for (int row = 0; row < free_.height; ++row) {
            int run = 0;
            for (int column = 0; column < free_.width; ++column) {
                int& height = tall[static_cast<std::size_t>(column)];
                height = free_.contains(column, row) ? height + 1 : 0;
                run = height >= rows ? run + 1 : 0;
                if (run == columns)
                    return Vec2d{(column + 1 - 0.5 * columns) * cell_.x, (row + 1 - 0.5 * rows) * cell_.y};
            }
        }
        return {};
    }

  private:
    Vec2d cell_;
    Mask free_;
};

/// Whether the piece has the half's corner at BACK and low z.
bool has_odd_corner(const SheetStack& stack, const SheetPiece& piece) {
    const int row = stack.piece.half() == Half::lower ? 0 : stack.rows() - 1;
    return piece.mask.contains(-piece.column, row - piece.row);
}

std::vector<Vec2d> odd_corner(const SheetStack& stack, const SheetPiece& piece) {
    const double side = std::min({kOddCorner, 0.8 * stack.cell_mm.x, 0.8 * stack.cell_mm.y});
    if (stack.piece.half() == Half::lower) return {{0, side}, {side, 0}};
    const double bottom = piece.mask.height * stack.cell_mm.y;
    return {{0, bottom - side}, {side, bottom}};
}

std::optional<Lines> placed_label(const SheetStack& stack, const SheetPiece& piece, const FreeCells& free) {
    struct Variant {
        std::string words;
        bool arrow;
    };
    std::vector<Variant> variants{{piece.name, true}, {piece.name, false}};
    if (!piece.island) variants.insert(variants.begin(), {piece.name + " BACK", true});
    for (const Variant& variant : variants) {
        for (const double height : kHeights) {
            Lines lines = label(stack.piece.half(), variant.words, height, variant.arrow);
            const Extent box = extent(lines);
            const auto middle = free.room_for(box.high - box.low + Vec2d{2 * kAround, 2 * kAround});
            if (!middle) continue;
            move(lines, *middle - (box.low + box.high) * 0.5);
            return lines;
        }
    }
    return {};
}

}  // namespace

std::vector<std::vector<Vec2d>> back_arrow(Half half, Vec2d at, double height) {
    const double wing = 0.25 * height;
    const Vec2d top = at - Vec2d{0, height};
    const Vec2d tip = half == Half::lower ? top : at;
    const double back = half == Half::lower ? wing : -wing;
    return {{at, top}, {tip + Vec2d{-wing, back}, tip, tip + Vec2d{wing, back}}};
}

Engraving engraving(const SheetStack& stack, const SheetPiece& piece, const std::vector<Vec2d>& holes,
                    double hole_radius, const std::vector<ItemLabel>& labels) {
    FreeCells free(stack, piece);
    const Vec2d reach{hole_radius + kAround, hole_radius + kAround};
    for (const Vec2d hole : holes) free.take(hole - reach, hole + reach);
    Engraving made;
    for (const ItemLabel& label : labels) {
        Lines lines = label_lines(label);
        move(lines, Vec2d{-piece.column * stack.cell_mm.x, -piece.row * stack.cell_mm.y});
        const Extent there = extent(lines);
        free.take(there.low - Vec2d{kAround, kAround}, there.high + Vec2d{kAround, kAround});
        append(made.lines, std::move(lines));
    }
    if (has_odd_corner(stack, piece)) {
        made.lines.push_back(odd_corner(stack, piece));
        const double row = stack.piece.half() == Half::lower ? 0.5 : piece.mask.height - 0.5;
        const Vec2d middle{0.5 * stack.cell_mm.x, row * stack.cell_mm.y};
        free.take(middle, middle + Vec2d{1e-6, 1e-6});
    }
    auto words = placed_label(stack, piece, free);
    made.numbered = words.has_value();
    if (words) append(made.lines, std::move(*words));
    return made;
}

}  // namespace snug
