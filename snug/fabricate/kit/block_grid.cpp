#include "snug/fabricate/kit/block_grid.h"

#include <algorithm>
#include <utility>

#include "snug/drawing/text_lines.h"
#include "snug/fabricate/kit/block_names.h"

namespace snug {
namespace {

constexpr double kLeastName = 1.9;     // mm, the smallest letters that are read on paper
constexpr double kGreatestName = 3.6;  // mm
constexpr double kNameDistance = 1.6;  // mm from the foam's edge
constexpr double kLeastCutCorner = 3;  // mm
constexpr double kCutCorner = 6;       // mm, where the blocks are no smaller
constexpr double kGridLine = 0.12;     // mm
constexpr double kFinestGrid = 1.4;    // mm, cells smaller than this get no lines between them

/// Every how many cells one is named: 1, 2, 5, 10, 20, 50, ...
int name_step(double cell_mm, double needed_mm) {
    int step = 1;
    for (int times = 0; step * cell_mm < needed_mm; ++times) step = times % 3 == 1 ? step / 2 * 5 : step * 2;
    return step;
}

/// Calls draw(begin, end) for each run of numbers below `count` that `inside` holds for.
template <class Inside, class Draw>
void for_each_run(int count, Inside inside, Draw draw) {
    for (int begin = 0; begin < count;) {
        if (!inside(begin)) {
            ++begin;
            continue;
        }
        int end = begin + 1;
        while (end < count && inside(end)) ++end;
        draw(begin, end);
        begin = end;
    }
}

double cut_corner(const BlockGrid& grid) {
    const double of_a_block = 0.8 * std::max(grid.cell.x, grid.cell.y);
    return std::min(
        {std::clamp(of_a_block, kLeastCutCorner, kCutCorner), 0.2 * grid.size().x, 0.2 * grid.size().y});
}

}  // namespace

void draw_cells(PageBuilder& page, const BlockGrid& grid, const CellTest& inside, Color fill) {
    std::vector<std::vector<Vec2d>> runs;
    for (int row = 0; row < grid.rows; ++row)
        for_each_run(
            grid.columns, [&](int column) { return inside(row, column); },
            [&](int begin, int end) {
                runs.push_back(
                    {grid.at(row, begin), grid.at(row, end), grid.at(row + 1, end), grid.at(row + 1, begin)});
            });
    if (!runs.empty()) page.loops(std::move(runs), fill);
}

void draw_borders(PageBuilder& page, const BlockGrid& grid, const CellTest& inside, const Pen& pen) {
    std::vector<std::vector<Vec2d>> lines;
    const auto in = [&](int row, int column) {
        return row >= 0 && column >= 0 && row < grid.rows && column < grid.columns && inside(row, column);
    };
    for (int row = 0; row <= grid.rows; ++row)
        for_each_run(
            grid.columns, [&](int column) { return in(row - 1, column) != in(row, column); },
            [&](int begin, int end) {
                lines.push_back({grid.at(row, begin), grid.at(row, end)});
            });
    for (int column = 0; column <= grid.columns; ++column)
        for_each_run(
            grid.rows, [&](int row) { return in(row, column - 1) != in(row, column); },
            [&](int begin, int end) {
                lines.push_back({grid.at(begin, column), grid.at(end, column)});
            });
    if (!lines.empty()) page.lines(std::move(lines), pen);
}

void draw_grid(PageBuilder& page, const BlockGrid& grid) {
    std::vector<std::vector<Vec2d>> lines;
    if (grid.cell.y >= kFinestGrid)
        for (int row = 1; row < grid.rows; ++row)
            lines.push_back({grid.at(row, 0), grid.at(row, grid.columns)});
    if (grid.cell.x >= kFinestGrid)
        for (int column = 1; column < grid.columns; ++column)
            lines.push_back({grid.at(0, column), grid.at(grid.rows, column)});
    if (!lines.empty()) page.lines(std::move(lines), {kHairline, kGridLine, {}});
}

void draw_edge(PageBuilder& page, const BlockGrid& grid) {
    const bool lower = grid.half == Half::lower;
    const Vec2d back_left = grid.at(lower ? 0 : grid.rows, 0),
                back_right = back_left + Vec2d{grid.size().x, 0};
    page.rectangle(grid.corner, grid.size(), {}, Pen{kInk, 0.35, {}});
    page.line(back_left, back_right, {kInk, 1.1, {}});
    const double cut = cut_corner(grid), inward = lower ? cut : -cut;
    page.loops({{back_left, back_left + Vec2d{cut, 0}, back_left + Vec2d{0, inward}}}, kInk);
    const double outward = kGridMargin - 2.2;
    page.text({grid.corner.x + grid.size().x / 2, back_left.y + (lower ? -outward + 2.6 : outward)},
              say("mark.back"), {kHeadingText, kInk, true, TextAnchor::middle});
}

void draw_names(PageBuilder& page, const BlockGrid& grid) {
    const auto look = [](double room, TextAnchor anchor) {
        return TextLook{std::clamp(0.45 * room, kLeastName, kGreatestName), kSoftInk, false, anchor};
    };
    const int row_step = name_step(grid.cell.y, kLeastName * 1.3);
    const std::string longest = column_name(grid.columns - 1);
    const int column_step = name_step(grid.cell.x, text_width(longest + "0", kLeastName));
    for (int row = 0; row < grid.rows; ++row) {
        const int from_back = grid.row_from_back(row);
        if (from_back % row_step != 0) continue;
        const TextLook left = look(grid.cell.y * row_step, TextAnchor::end);
        const double baseline = grid.middle(row, 0).y + left.height_mm * 0.36;
        page.text({grid.corner.x - kNameDistance, baseline}, row_name(from_back), left);
        page.text({grid.corner.x + grid.size().x + kNameDistance, baseline}, row_name(from_back),
                  look(grid.cell.y * row_step, TextAnchor::start));
    }
    for (int column = 0; column < grid.columns; ++column) {
        if (column > 0 && (column + 1) % column_step != 0) continue;
        TextLook above = look(grid.cell.x * column_step, TextAnchor::middle);
        while (above.height_mm > kLeastName &&
               text_width(longest, above.height_mm) > 0.85 * grid.cell.x * column_step)
            above.height_mm -= 0.1;
        const double x = grid.middle(0, column).x;
        page.text({x, grid.corner.y - kNameDistance}, column_name(column), above);
        page.text({x, grid.corner.y + grid.size().y + kNameDistance + 0.72 * above.height_mm},
                  column_name(column), above);
    }
}

}  // namespace snug
