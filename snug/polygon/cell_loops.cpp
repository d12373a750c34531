#include "snug/polygon/cell_loops.h"

#include <tuple>
#include <utility>

namespace snug {
namespace {

/// Walks along the cracks between inside and outside cells, the inside on its right-hand side.
class Tracer {
  public:
    explicit Tracer(const Mask& mask) : mask_(mask), begun_(mask.cells.size(), 0) {}

    std::vector<CellLoop> trace() {
        std::vector<CellLoop> loops;
        // Every loop, around cells or around a hole, passes above some cell from left to right.
        for (int row = 0; row < mask_.height; ++row)
            for (int column = 0; column < mask_.width; ++column)
                if (mask_.contains(column, row) && !mask_.contains(column, row - 1) && !begun(column, row))
                    loops.push_back(follow(column, row));
        return loops;
    }

  private:
    char& begun(int column, int row) {
        return begun_[static_cast<std::size_t>(row) * static_cast<std::size_t>(mask_.width) +
                      static_cast<std::size_t>(column)];
    }

    /// The loop that begins at a cell's upper left corner, which is a corner of the loop: along a straight
    /// side this cell would have been passed before.
    CellLoop follow(int first_column, int first_row) {
        CellLoop loop;
        int x = first_column, y = first_row, dx = 1, dy = 0;
        bool turned = true;
        do {
            if (turned) loop.push_back({x, y});
            if (dx == 1) begun(x, y) = 1;
            x += dx;
            y += dy;
            // The cells ahead lie around the corner (x, y): to the left (dy, -dx), to the right (-dy, dx).
            const bool left = mask_.contains(x + (dx + dy - 1) / 2, y + (dy - dx - 1) / 2);
            const bool right = mask_.contains(x + (dx - dy - 1) / 2, y + (dy + dx - 1) / 2);
            turned = left || !right;
            if (left)
                std::tie(dx, dy) = std::pair(dy, -dx);
            else if (!right)
                std::tie(dx, dy) = std::pair(-dy, dx);
        } while (x != first_column || y != first_row || dx != 1 || dy != 0);
        return loop;
    }

    const Mask& mask_;
    std::vector<char> begun_;
};

}  // namespace

std::vector<CellLoop> cell_loops(const Mask& mask) {
    return Tracer(mask).trace();
}

}  // namespace snug
