#include "snug/fabricate/sheets/sheet_outlines.h"

#include <cstddef>
#include <cstdlib>
#include <utility>

namespace snug {
namespace {

struct Step {
    int x, y;
};

Step direction(CellPoint from, CellPoint to) {
    return {(to.x > from.x) - (to.x < from.x), (to.y > from.y) - (to.y < from.y)};
}

/// Whether the cell to the left of one step of a walk around the foam above belongs to the piece, so that the
/// line lies on it.
bool on_piece(const SheetPiece& piece, CellPoint from, Step step) {
    const int column = from.x + (step.x + step.y - 1) / 2, row = from.y + (step.y - step.x - 1) / 2;
    return piece.mask.contains(column, row);
}

/// The parts of a loop that lie on the piece, corners only.
class LoopParts {
  public:
    LoopParts(const SheetPiece& piece, Vec2d cell) : piece_(piece), cell_(cell) {}

    void add(const CellLoop& loop) {
        const std::size_t first = parts_.size();
        open_ = false;
        bool whole = true, starts_on = false;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const CellPoint to = loop[i + 1 == loop.size() ? 0 : i + 1];
            const Step step = direction(loop[i], to);
            bool corner = true;
            for (CellPoint at = loop[i]; at != to; at = {at.x + step.x, at.y + step.y}, corner = false) {
                const bool on = on_piece(piece_, at, step);
                if (i == 0 && corner) starts_on = on;
                whole = whole && on;
                take(on, corner, at, {at.x + step.x, at.y + step.y});
            }
        }
        // The last part runs on into the first one where the loop begins on the piece and is not whole.
        if (whole || !open_ || !starts_on || parts_.size() < first + 2) return;
        std::vector<Vec2d> joined = std::move(parts_.back());
        joined.insert(joined.end(), parts_[first].begin() + 1, parts_[first].end());
        parts_[first] = std::move(joined);
        parts_.pop_back();
    }

    [[nodiscard]] std::vector<std::vector<Vec2d>> finish() { return std::move(parts_); }

  private:
    void take(bool on, bool corner, CellPoint from, CellPoint to) {
        if (on && !open_) parts_.push_back({mm(from), mm(to)});
        if (on && open_ && corner) parts_.back().push_back(mm(to));
        if (on && open_ && !corner) parts_.back().back() = mm(to);
        open_ = on;
    }

    [[nodiscard]] Vec2d mm(CellPoint p) const { return {p.x * cell_.x, p.y * cell_.y}; }

    const SheetPiece& piece_;
    Vec2d cell_;
    bool open_ = false;  ///< the last part may go on
    std::vector<std::vector<Vec2d>> parts_;
};

}  // namespace

std::vector<Vec2d> offset_outline(const CellLoop& loop, Vec2d cell_mm, double offset_mm) {
    std::vector<Vec2d> line;
    line.reserve(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const CellPoint at = loop[i];
        const Step in = direction(loop[i == 0 ? loop.size() - 1 : i - 1], at);
        const Step out = direction(at, loop[i + 1 == loop.size() ? 0 : i + 1]);
        // The inside is on the right-hand side, so outward is to the left: (dy, -dx).
        line.push_back(
            {at.x * cell_mm.x + offset_mm * (in.y + out.y), at.y * cell_mm.y - offset_mm * (in.x + out.x)});
    }
    return line;
}

std::vector<std::vector<Vec2d>> outline_above(const SheetStack& stack, const SheetPiece& piece) {
    Mask above(piece.mask.width, piece.mask.height);
    bool less = false;
    for (int row = 0; row < above.height; ++row)
        for (int column = 0; column < above.width; ++column) {
            if (!piece.mask.contains(column, row)) continue;
            if (stack.has(piece.row + row, piece.column + column, piece.sheet + 1))
                above.set(column, row);
            else
                less = true;
        }
    if (!less) return {};
    LoopParts parts(piece, stack.cell_mm);
    for (const CellLoop& loop : cell_loops(above)) parts.add(loop);
    return parts.finish();
}

}  // namespace snug
