#include "snug/fabricate/sheets/cut_piece.h"

#include <cstddef>
#include <utility>

#include "snug/fabricate/sheets/sheet_engraving.h"
#include "snug/fabricate/sheets/sheet_outlines.h"
#include "snug/polygon/polygon.h"

namespace snug {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Middle of a dowel hole from the piece's own corner; the cell there tells whether it is in this piece.
bool in_piece(const SheetPiece& piece, Vec2d at, Vec2d cell) {
    return at.x >= 0 && at.y >= 0 &&
           piece.mask.contains(static_cast<int>(at.x / cell.x), static_cast<int>(at.y / cell.y));
}

/// The labels that are engraved on a piece: those on the uppermost sheet at their place.
std::vector<ItemLabel> labels_on(const SheetStack& stack, const SheetPiece& piece,
                                 std::span<const ItemLabel> labels) {
    std::vector<ItemLabel> own;
    for (const ItemLabel& label : labels) {
        const int row = static_cast<int>(label.middle.y / stack.cell_mm.y),
                  column = static_cast<int>(label.middle.x / stack.cell_mm.x);
        if (stack.piece.index == label.layer - 1 && stack.kept(row, column) - 1 == piece.sheet &&
            piece.mask.contains(column - piece.column, row - piece.row))
            own.push_back(label);
    }
    return own;
}

/// Slits run in foam alone, so that where one begins tells which piece it is on.
std::vector<std::vector<Vec2d>> slits_on(const SheetPiece& piece, Vec2d corner, Vec2d cell,
                                         std::span<const std::vector<Vec2d>> slits) {
    std::vector<std::vector<Vec2d>> own;
    for (const std::vector<Vec2d>& slit : slits) {
        if (!in_piece(piece, slit.front() - corner, cell)) continue;
        own.push_back(slit);
        for (Vec2d& p : own.back()) p = p - corner;
    }
    return own;
}

}  // namespace

CutPiece cut_piece(const SheetStack& stack, const SheetPiece& piece, const DowelHoles& dowels,
                   const SheetOptions& options, std::span<const ItemLabel> labels,
                   std::span<const std::vector<Vec2d>> slits) {
    CutPiece made;
    for (std::size_t i = 0; i < piece.loops.size(); ++i) {
        auto line = offset_outline(piece.loops[i], stack.cell_mm, options.kerf_mm / 2);
        if (i == 0)
            made.outer = std::move(line);
        else
            made.inner.push_back(std::move(line));
    }
    std::vector<Vec2d> holes;
    const Vec2d corner{piece.column * stack.cell_mm.x, piece.row * stack.cell_mm.y};
    if (piece.sheet < dowels.sheets)
        for (const Vec2d centre : dowels.centres)
            if (in_piece(piece, centre - corner, stack.cell_mm)) holes.push_back(centre - corner);
    for (const Vec2d hole : holes)
        made.circles.push_back({hole, 0.5 * (options.dowel_mm - options.kerf_mm), {}, {}});
    const std::vector<ItemLabel> own = labels_on(stack, piece, labels);
    Engraving words = engraving(stack, piece, holes, 0.5 * options.dowel_mm, own);
    made.engraved = std::move(words.lines);
    made.numbered = words.numbered;
    made.marked = outline_above(stack, piece);
    if (piece.sheet == stack.count - 1) made.slit = slits_on(piece, corner, stack.cell_mm, slits);
    return made;
}

double cut_length(const CutPiece& piece) {
    double sum = perimeter(piece.outer);
    for (const auto& loop : piece.inner) sum += perimeter(loop);
    for (const CircleItem& circle : piece.circles) sum += 2 * kPi * circle.radius_mm;
    return sum;
}

}  // namespace snug
