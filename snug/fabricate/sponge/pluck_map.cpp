#include "snug/fabricate/sponge/pluck_map.h"

#include <algorithm>
#include <utility>

#include "snug/base/text.h"
#include "snug/drawing/svg.h"
#include "snug/drawing/text_lines.h"
#include "snug/fabricate/kit/block_grid.h"
#include "snug/fabricate/kit/block_names.h"

namespace snug {
namespace {

constexpr double kTitleStrip = 17;        // mm above a map at true size
constexpr double kNarrowestMap = 120;     // mm, so that the title has room
constexpr double kWidestHead = 160;       // mm, so that no tile cuts it
constexpr double kLeastCellName = 7;      // mm, cells that carry their own name
constexpr double kLeastNumberCell = 3.2;  // mm, cells that carry a number
constexpr double kOverviewHead = 34, kOverviewFoot = 30;

/// What stands above a map: a name in large letters, what it is, and a line of what to do.
struct MapHead {
    std::string name, title, task;
    Color color;
};

/// A page with a grid at true size under its head.
struct MapPage {
    PageBuilder page;
    BlockGrid grid;
};
MapPage map_page(BlockGrid grid, const std::string& object_name, const MapHead& head) {
    const double width = std::max(kNarrowestMap, grid.size().x + 2 * kGridMargin);
    const double head_width = std::min(width - 2 * kGridMargin, kWidestHead);
    const std::vector<std::string> task = lines_of(head.task, head_width, kBodyText);
    const double strip = kTitleStrip + (static_cast<double>(task.size()) - 1) * kBodyText * kLineSpacing;
    grid.corner = {kGridMargin, strip + kGridMargin};
    MapPage map{PageBuilder(object_name + ": " + head.name + ", " + head.title,
                            {width, strip + grid.size().y + 2 * kGridMargin}),
                grid};
    map.page.text({kGridMargin, 8.5}, head.name, {kTitleText, head.color, true});
    map.page.text({kGridMargin + text_width(head.name, kTitleText, true) + 5, 8.5}, head.title,
                  {kHeadingText, kInk, true});
    map.page.paragraph({kGridMargin, 11.5}, head_width, head.task, {kBodyText, kSoftInk});
    return map;
}

void name_cells(PageBuilder& page, const BlockGrid& grid, const CellTest& inside, Color color) {
    const double room = std::min(grid.cell.x, grid.cell.y);
    if (room < kLeastCellName) return;
    const TextLook look{std::min(kSmallText, room * 0.3), color, false, TextAnchor::middle};
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            if (inside(row, column))
                page.text(grid.middle(row, column) + Vec2d{0, look.height_mm * 0.36},
                          row_name(grid.row_from_back(row)) + column_name(column), look);
}

/// The largest cell with the blocks' proportions that fits the page's room, or a smaller side where blocks
/// are far from square.
Vec2d overview_cell_on(const PluckPlan& plan, Vec2d page_mm) {
    const Vec2d room{page_mm.x - 2 * kPageMargin - 2 * kGridMargin,
                     page_mm.y - kOverviewHead - kOverviewFoot - 2 * kGridMargin};
    const Vec2d size{plan.column_mm * plan.removed.nz(), plan.row_mm * plan.removed.ny()};
    const double scale = std::min(room.x / size.x, room.y / size.y);
    return {plan.column_mm * scale, plan.row_mm * scale};
}

/// The overview lies across where its blocks are larger so.
struct Overview {
    Vec2d page_mm, cell;
};
Overview overview_of(const PluckPlan& plan, Vec2d paper) {
    const Vec2d across{paper.y, paper.x};
    const Overview upright{paper, overview_cell_on(plan, paper)},
        lying{across, overview_cell_on(plan, across)};
    return lying.cell.x > upright.cell.x ? lying : upright;
}

Color shade(const PluckPlan& plan, int removed) {
    if (removed == 0) return kPaper;
    const double share = static_cast<double>(removed) / std::max(1, plan.deepest());
    const Color deep = mixed(half_color(plan.half), {0, 0, 0}, 0.35);
    return mixed(mixed(half_color(plan.half), kPaper, 0.82), deep, share);
}

/// White on the dark shades.
Color number_color(const PluckPlan& plan, int removed) {
    return 10 * removed > 5 * plan.deepest() ? kPaper : kInk;
}

void draw_depths(PageBuilder& page, const BlockGrid& grid, const PluckPlan& plan, bool with_numbers) {
    std::vector<char> used(static_cast<std::size_t>(plan.deepest()) + 1, 0);
    for (const auto removed : plan.removed) used[removed] = 1;
    for (std::size_t removed = 1; removed < used.size(); ++removed)
        if (used[removed])
            draw_cells(
                page, grid,
                [&](int row, int column) { return plan.removed(row, column) == static_cast<int>(removed); },
                shade(plan, static_cast<int>(removed)));
    if (plan.cut_off > 0)  // what keeps a block is white
        draw_cells(
            page, grid, [&](int row, int column) { return plan.exists(row, column).none(); },
            mixed(kSoftInk, kPaper, 0.35));
    draw_grid(page, grid);
    draw_borders(page, grid, [&](int row, int column) { return plan.removed(row, column) > 0; },
                 {kInk, 0.35, {}});
    if (!with_numbers) return;
    const double height = std::min({kHeadingText, grid.cell.y * 0.6,
                                    grid.cell.x * (plan.deepest() > 99  ? 0.42
                                                   : plan.deepest() > 9 ? 0.6
                                                                        : 0.7)});
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            if (const int removed = plan.removed(row, column); removed > 0)
                page.text(grid.middle(row, column) + Vec2d{0, height * 0.36}, std::to_string(removed),
                          {height, number_color(plan, removed), false, TextAnchor::middle});
}

/// White to the deepest shade, in steps.
void draw_scale(PageBuilder& page, const PluckPlan& plan, Vec2d at) {
    const int deepest = plan.deepest();
    const int steps = std::min(deepest, 8);
    const TextLook look{kSmallText, kSoftInk, false, TextAnchor::middle};
    page.text(at + Vec2d{0, 3.6}, "Blocks to remove", {kSmallText, kSoftInk});
    for (int step = 0; step <= steps; ++step) {
        const int removed = steps == 0 ? 0 : (deepest * step + steps / 2) / steps;
        const Vec2d corner = at + Vec2d{26.0 + 9.0 * step, 0};
        page.rectangle(corner, {9, 5}, shade(plan, removed), Pen{kHairline, 0.15, {}});
        page.text(corner + Vec2d{4.5, 8.4}, std::to_string(removed), look);
    }
}

}  // namespace

Drawing pluck_map(const PluckPlan& plan, const LayerRun& run, const std::string& object_name) {
    const CellTest plucked = [&](int row, int column) { return plan.plucked_at(row, column, run.first); };
    const std::string pluck =
        run.plucked == 0
            ? "Nothing to pluck."
            : "Pluck " + counted(static_cast<unsigned long long>(run.plucked), "block", "blocks") +
                  (run.layers() > 1 ? " in each" : "") + ": the shaded ones.";
    const CellTest cut_off = [&](int row, int column) { return plan.cut_off_at(row, column, run.first); };
    const std::string trim =
        run.cut_off > 0
            ? " Cut off " + counted(static_cast<unsigned long long>(run.cut_off), "block", "blocks") +
                  (run.layers() > 1 ? " in each" : "") + ": the grey ones, for which the case has no room."
            : "";
    const std::string task =
        pluck + trim + " Cavity facing you; layer 1 is the one at the cavity. True size. " + object_name;
    MapPage map = map_page(
        {plan.half, plan.removed.ny(), plan.removed.nz(), {}, {plan.column_mm, plan.row_mm}}, object_name,
        {std::string(half_title(plan.half)), layers_text(run) + " of " + std::to_string(plan.layers), task,
         half_ink(plan.half)});
    const Color tint = mixed(half_color(plan.half), kPaper, 0.55);
    map.page.layer("pluck", half_color(plan.half));
    draw_cells(map.page, map.grid, plucked, tint);
    if (run.cut_off > 0) {
        map.page.layer("cut-off", kSoftInk);
        draw_cells(map.page, map.grid, cut_off, mixed(kSoftInk, kPaper, 0.35));
    }
    map.page.layer("grid", kHairline);
    draw_grid(map.page, map.grid);
    draw_borders(map.page, map.grid, plucked, {half_ink(plan.half), 0.6, {}});
    if (run.cut_off > 0) draw_borders(map.page, map.grid, cut_off, {kInk, 0.6, {}});
    map.page.layer("edge", kInk);
    draw_edge(map.page, map.grid);
    map.page.layer("notes", kInk);
    draw_names(map.page, map.grid);
    name_cells(map.page, map.grid, plucked, half_ink(plan.half));
    return map.page.finish();
}

Drawing fit_test_map(const FitTest& test, const DesignSpace& space, const std::string& object_name) {
    // A ring has no lid: it lies as the lower half does.
    const CellTest ring = [&](int row, int column) { return test.ring(row, column) != 0; };
    MapPage map = map_page(
        {Half::lower, test.ring.ny(), test.ring.nz(), {}, {space.block_mm.z, space.block_mm.y}}, object_name,
        {"FIT TEST", "ring of one layer",
         "Keep the shaded ring, pluck what is inside, cut off what is outside. Lies as the lower foam, "
         "cavity "
         "facing you. True size. " +
             object_name,
         kInk});
    map.page.layer("ring", kSoftInk);
    draw_cells(map.page, map.grid, ring, mixed(kSoftInk, kPaper, 0.6));
    map.page.layer("grid", kHairline);
    draw_grid(map.page, map.grid);
    draw_borders(map.page, map.grid, ring, {kInk, 0.6, {}});
    map.page.layer("edge", kInk);
    draw_edge(map.page, map.grid);
    map.page.layer("notes", kInk);
    draw_names(map.page, map.grid);
    return map.page.finish();
}

bool overview_has_numbers(const PluckPlan& plan, Vec2d paper) {
    const Vec2d cell = overview_of(plan, paper).cell;
    return std::min(cell.x, cell.y) >= kLeastNumberCell;
}

Drawing pluck_overview(const PluckPlan& plan, Vec2d paper, const std::string& object_name) {
    const auto [page_mm, cell] = overview_of(plan, paper);
    const std::string name(half_title(plan.half));
    PageBuilder page(object_name + ": " + name + ", overview", page_mm);
    const double width = page_mm.x - 2 * kPageMargin;
    const bool with_numbers = overview_has_numbers(plan, paper);
    page.text({kPageMargin, kPageMargin + 7}, name, {kTitleText, half_ink(plan.half), true});
    page.text({page_mm.x - kPageMargin, kPageMargin + 7},
              shortened(object_name, width * 0.7, {kHeadingText, kInk, true}),
              {kHeadingText, kInk, true, TextAnchor::end});
    page.paragraph({kPageMargin, kPageMargin + 9.5}, width,
                   "Cavity facing you. " +
                       std::string(with_numbers ? "The number says how many blocks to remove from this column"
                                                : "The shade says how many blocks to remove from a column, "
                                                  "the table how many from which") +
                       ", from the cavity's side; white columns stay whole. Not at true size.",
                   {kBodyText, kSoftInk});

    BlockGrid grid{plan.half, plan.removed.ny(), plan.removed.nz(), {}, cell};
    grid.corner = {(page_mm.x - grid.size().x) / 2, kOverviewHead + kGridMargin};
    page.layer("pluck", half_color(plan.half));
    draw_depths(page, grid, plan, with_numbers);
    page.layer("edge", kInk);
    draw_edge(page, grid);
    page.layer("notes", kInk);
    draw_names(page, grid);

    const double foot = grid.corner.y + grid.size().y + kGridMargin + 6;
    draw_scale(page, plan, {kPageMargin, foot});
    page.text({page_mm.x - kPageMargin, foot + 3.8},
              grouped(static_cast<unsigned long long>(plan.plucked)) + " blocks to remove",
              {kHeadingText, half_ink(plan.half), true, TextAnchor::end});
    page.text({page_mm.x - kPageMargin, foot + 9},
              "from " + std::to_string(plan.layers) + " layers of " + number(plan.layer_mm, 2) + " mm",
              {kBodyText, kSoftInk, false, TextAnchor::end});
    return page.finish();
}

}  // namespace snug
