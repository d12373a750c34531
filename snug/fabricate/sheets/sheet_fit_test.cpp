#include "snug/fabricate/sheets/sheet_fit_test.h"

#include <algorithm>
#include <vector>

#include "snug/fabricate/sheets/cut_piece.h"
#include "snug/fabricate/sheets/nesting.h"
#include "snug/fabricate/sheets/sheet_drawing.h"

namespace snug {
namespace {

/// The drawing's size cut down to what is on it.
void crop(Drawing& drawing, const std::vector<SheetPiece>& pieces, const Nesting& nesting, Vec2d cell,
          double border) {
    Vec2d far;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Vec2d end =
            nesting.places[i].corner + Vec2d{pieces[i].mask.width * cell.x, pieces[i].mask.height * cell.y};
        far = {std::max(far.x, end.x), std::max(far.y, end.y)};
    }
    drawing.size_mm = far + Vec2d{border, border};
}

}  // namespace

std::optional<Drawing> sheet_fit_test(const FitTest& test, const FoamDesign& design,
                                      const SheetOptions& options) {
    SheetStack stack;
    stack.cell_mm = {design.space.block_mm.z, design.space.block_mm.y};
    stack.kept = Grid<int>(test.ring.ny(), test.ring.nz(), 0);
    stack.missing = stack.kept;
    for (std::size_t i = 0; i < stack.kept.size(); ++i) stack.kept[i] = test.ring[i] != 0;
    stack.count = 1;
    const std::vector<SheetPiece> pieces = sheet_pieces(stack, 0, "FIT");
    std::vector<PieceToNest> to_nest;
    std::vector<CutPiece> cuts;
    for (const SheetPiece& piece : pieces) {
        to_nest.push_back({piece.name, &piece.mask, piece.cells});
        cuts.push_back(cut_piece(stack, piece, {}, options));
    }
    SheetOptions roll = options;  // one drawing, however long
    roll.stock_mm = {std::max({options.stock_mm.x, options.stock_mm.y}), 1e7};
    const auto nesting = nest(to_nest, stack.cell_mm, roll);
    if (!nesting || pieces.empty()) return {};
    Drawing drawing = stock_drawing(cuts, *nesting, 0,
                                    say("sheets.fit_title", {{"name", design.object_name}}), design.language);
    crop(drawing, pieces, *nesting, stack.cell_mm, options.margin_mm + options.kerf_mm);
    return drawing;
}

}  // namespace snug
