#include "snug/fabricate/bricks/brick_courses.h"

#include <algorithm>
#include <utility>

namespace snug {
namespace {

/// Adds the course unless it is empty.
void add(std::vector<BrickCourse>& courses, const BrickShape& shape, BrickKind kind, int bottom,
         Grid<char> cells) {
    if (std::find(cells.begin(), cells.end(), 1) == cells.end()) return;
    BrickCourse course{kind, bottom, std::move(cells), Grid<char>(shape.rows(), shape.columns())};
    for (std::size_t i = 0; i < course.cells.size(); ++i) {
        if (!course.cells[i]) continue;
        const bool floats = bottom > 0 && bottom == shape.first[i] * shape.layer_plates;
        course.supported[i] = !floats;
        course.unsupported += floats;
    }
    courses.push_back(std::move(course));
}

}  // namespace

std::vector<BrickCourse> brick_courses(const BrickShape& shape, BrickRim rim) {
    const bool bricks = shape.layer_plates == kPlatesInBrick;
    std::vector<BrickCourse> courses;
    for (int layer = 0; layer < shape.layers(); ++layer) {
        Grid<char> plain(shape.rows(), shape.columns()), tiled(shape.rows(), shape.columns());
        for (int row = 0; row < shape.rows(); ++row)
            for (int column = 0; column < shape.columns(); ++column) {
                if (!shape.has(row, column, layer)) continue;
                const bool tile =
                    rim == BrickRim::tiles && shape.rim(row, column) && layer + 1 == shape.top(row, column);
                (tile ? tiled : plain)(row, column) = 1;
            }
        const int bottom = layer * shape.layer_plates;
        add(courses, shape, bricks ? BrickKind::brick : BrickKind::plate, bottom, std::move(plain));
        if (bricks) {
            add(courses, shape, BrickKind::plate, bottom, tiled);
            add(courses, shape, BrickKind::plate, bottom + 1, tiled);
        }
        add(courses, shape, BrickKind::tile, bottom + shape.layer_plates - 1, std::move(tiled));
    }
    return courses;
}

}  // namespace snug
