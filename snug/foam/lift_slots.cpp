#include "snug/foam/lift_slots.h"

#include <algorithm>
#include <cstddef>

#include "snug/space/fitted_space.h"

namespace snug {
namespace {

/// The columns with two opposite sides at the ends of one axis: `out` counts along it, `line` on the other.
struct TwoSides {
    const Grid<Run>& kept;
    int axis;
    [[nodiscard]] std::size_t column(int out, int line) const {
        return axis == 1 ? kept.index(out, line) : kept.index(line, out);
    }
    [[nodiscard]] int from(bool far, int i) const { return far ? outs() - 1 - i : i; }
    [[nodiscard]] int outs() const { return axis == 1 ? kept.ny() : kept.nz(); }
    [[nodiscard]] int lines() const { return axis == 1 ? kept.nz() : kept.ny(); }
};

/// In blocks.
struct SlotSize {
    int width, depth, margin_out, margin_line;
};

/// A column where no layer cuts anything: its foam carries no item and holds none.
Grid<char> free_columns(std::span<const BlockMap> layers) {
    Grid<char> free(layers.front().ny(), layers.front().nz(), 1);
    for (const BlockMap& layer : layers)
        for (std::size_t column = 0; column < layer.size(); ++column)
            if (!layer[column].none()) free[column] = 0;
    return free;
}

/// The outermost column that a piece keeps on a line, counted from one end; none where it keeps none.
std::optional<int> edge_of(const TwoSides& sides, bool far, int line) {
    for (int i = 0; i < sides.outs(); ++i)
        if (!sides.kept[sides.column(sides.from(far, i), line)].none()) return i;
    return {};
}

bool has_room(const TwoSides& sides, const Grid<char>& free, bool far, int first, const SlotSize& size) {
    if (first < 0 || first + size.width > sides.lines()) return false;
    int innermost = 0;
    for (int line = first; line < first + size.width; ++line) {
        const auto edge = edge_of(sides, far, line);
        if (!edge || *edge + size.depth > sides.outs()) return false;
        innermost = std::max(innermost, *edge + size.depth);
        for (int i = *edge; i < *edge + size.depth; ++i)
            if (sides.kept[sides.column(sides.from(far, i), line)].none()) return false;
    }
    if (innermost + size.margin_out > sides.outs()) return false;
    const int low = std::max(0, first - size.margin_line),
              high = std::min(sides.lines(), first + size.width + size.margin_line);
    for (int line = low; line < high; ++line)
        for (int i = 0; i < innermost + size.margin_out; ++i)
            if (!free[sides.column(sides.from(far, i), line)]) return false;
    return true;
}

/// Where both sides have room, nearest to the middle.
std::optional<int> first_line(const TwoSides& sides, const Grid<char>& free, const SlotSize& size) {
    const int middle = (sides.lines() - size.width) / 2;
    for (int off = 0; off <= sides.lines(); ++off)
        for (const int first : {middle - off, middle + off})
            if (has_room(sides, free, false, first, size) && has_room(sides, free, true, first, size))
                return first;
    return {};
}

void carve(Grid<Run>& kept, int axis, bool far, int first, const SlotSize& size) {
    const TwoSides sides{kept, axis};
    for (int line = first; line < first + size.width; ++line) {
        const int edge = *edge_of(sides, far, line);
        for (int i = edge; i < edge + size.depth; ++i) kept[sides.column(sides.from(far, i), line)] = {};
    }
}

/// Opposite each other at the ends of the longer way of the space that has room; none where neither has.
std::vector<LiftSlot> cut_two(Grid<Run>& kept, Piece piece, const Grid<char>& free, const DesignSpace& space,
                              const LiftOptions& options, double between_mm) {
    const auto blocks = [&](double mm, int axis) {
        return std::max(1, whole_blocks(mm, space.block_mm[axis]));
    };
    const int longer = space.size().y > space.size().z ? 1 : 2;
    for (const int axis : {longer, 3 - longer}) {
        const int other = 3 - axis;
        const SlotSize size{blocks(options.width_mm, other), blocks(options.depth_mm, axis),
                            blocks(between_mm, axis), blocks(between_mm, other)};
        const auto first = first_line({kept, axis}, free, size);
        if (!first) continue;
        std::vector<LiftSlot> slots;
        for (const bool far : {false, true}) {
            carve(kept, axis, far, *first, size);
            LiftSlot& slot = slots.emplace_back();
            slot.piece = piece;
            slot.side = static_cast<Side>(2 * axis + (far ? 1 : 0));
            slot.at_mm = (space.face(other, *first) + space.face(other, *first + size.width)) / 2;
            slot.size_mm[axis] = size.depth * space.block_mm[axis];
            slot.size_mm[other] = size.width * space.block_mm[other];
        }
        return slots;
    }
    return {};
}

}  // namespace

LiftSlots cut_lift_slots(Foams& foams, std::span<const BlockMap> layers, const DesignSpace& space,
                         const LiftOptions& options, double between_mm) {
    LiftSlots found;
    const Grid<char> free = free_columns(layers);
    for (const Piece piece : foams.all()) {
        if (piece.index == 0 && !foams.open()) continue;
        Grid<Run>& kept = foams.pieces[static_cast<std::size_t>(piece.index)];
        const std::vector<LiftSlot> slots = cut_two(kept, piece, free, space, options, between_mm);
        found.slots.insert(found.slots.end(), slots.begin(), slots.end());
        if (slots.empty()) found.without.push_back(piece);
    }
    return found;
}

}  // namespace snug
