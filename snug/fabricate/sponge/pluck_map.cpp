#include "snug/fabricate/sponge/pluck_map.h"

#include <algorithm>
#include <utility>

#include "snug/base/text.h"
#include "snug/drawing/svg.h"
#include "snug/drawing/text_lines.h"
#include "snug/fabricate/kit/block_grid.h"
#include "snug/fabricate/kit/block_names.h"
#include "snug/words/pieces.h"

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
    Message name, title, task;
    Color color;
};

/// A page with a grid at true size under its head.
struct MapPage {
    PageBuilder page;
    BlockGrid grid;
};
MapPage map_page(BlockGrid grid, const FoamDesign& design, const MapHead& head) {
    const double width = std::max(kNarrowestMap, grid.size().x + 2 * kGridMargin);
    const double head_width = std::min(width - 2 * kGridMargin, kWidestHead);
    const std::string task = text(head.task, design.language);
    const double lines = static_cast<double>(lines_of(task, head_width, kBodyText).size());
    const double strip = kTitleStrip + (lines - 1) * kBodyText * kLineSpacing;
    grid.corner = {kGridMargin, strip + kGridMargin};
    const Message title =
        say("sponge.map", {{"name", design.object_name}, {"half", head.name}, {"layers", head.title}});
    MapPage map{PageBuilder(text(title, design.language), {width, strip + grid.size().y + 2 * kGridMargin},
                            design.language),
                grid};
    const std::string name = text(head.name, design.language);
    map.page.text({kGridMargin, 8.5}, name, {kTitleText, head.color, true});
    map.page.text({kGridMargin + text_width(name, kTitleText, true) + 5, 8.5}, head.title,
                  {kHeadingText, kInk, true});
    map.page.paragraph({kGridMargin, 11.5}, head_width, task, {kBodyText, kSoftInk});
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
    const Color deep = mixed(piece_color(plan.piece), {0, 0, 0}, 0.35);
    return mixed(mixed(piece_color(plan.piece), kPaper, 0.82), deep, share);
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
    page.text(at + Vec2d{0, 3.6}, say("sponge.scale"), {kSmallText, kSoftInk});
    for (int step = 0; step <= steps; ++step) {
        const int removed = steps == 0 ? 0 : (deepest * step + steps / 2) / steps;
        const Vec2d corner = at + Vec2d{26.0 + 9.0 * step, 0};
        page.rectangle(corner, {9, 5}, shade(plan, removed), Pen{kHairline, 0.15, {}});
        page.text(corner + Vec2d{4.5, 8.4}, std::to_string(removed), look);
    }
}

/// "layer 3 of 12"
Message title_of(const LayerRun& run, int layers) {
    const std::string first = std::to_string(run.first), all = std::to_string(layers);
    if (run.layers() == 1) return say("sponge.layer_of", {{"layer", first}, {"layers", all}});
    return say("sponge.layers_of", {{"first", first}, {"last", std::to_string(run.last)}, {"layers", all}});
}

Message task_of(const LayerRun& run, const std::string& object_name) {
    const bool several = run.layers() > 1;
    const Message pluck = run.plucked == 0 ? say("sponge.pluck_none")
                                           : say(several ? "sponge.pluck_in_each" : "sponge.pluck_shaded",
                                                 {{"blocks", run.plucked}});
    std::vector<Message> cut_off;
    if (run.cut_off > 0)
        cut_off.push_back(
            say(several ? "sponge.cut_off_in_each" : "sponge.cut_off", {{"blocks", run.cut_off}}));
    return say("sponge.map_task", {{"pluck", pluck}, {"cut_off", cut_off}, {"name", object_name}});
}

/// On the surface, beside the items that lie in the piece.
void write_labels(MapPage& map, Piece piece, const FoamDesign& design) {
    map.page.layer("labels", kInk);
    for (const ItemLabel& label : design.labels)
        if (label.layer == piece.index + 1)
            map.page.text(map.grid.corner + label.middle + Vec2d{0, 0.35 * label.height_mm}, label.words,
                          {label.height_mm, kInk, true, TextAnchor::middle});
}

}  // namespace

Drawing pluck_map(const PluckPlan& plan, const LayerRun& run, const FoamDesign& design) {
    const CellTest plucked = [&](int row, int column) { return plan.plucked_at(row, column, run.first); };
    const CellTest cut_off = [&](int row, int column) { return plan.cut_off_at(row, column, run.first); };
    MapPage map =
        map_page({plan.half, plan.removed.ny(), plan.removed.nz(), {}, {plan.column_mm, plan.row_mm}}, design,
                 {marked_piece(plan.piece), title_of(run, plan.layers), task_of(run, design.object_name),
                  piece_ink(plan.piece)});
    const Color tint = mixed(piece_color(plan.piece), kPaper, 0.55);
    map.page.layer("pluck", piece_color(plan.piece));
    draw_cells(map.page, map.grid, plucked, tint);
    if (run.cut_off > 0) {
        map.page.layer("cut-off", kSoftInk);
        draw_cells(map.page, map.grid, cut_off, mixed(kSoftInk, kPaper, 0.35));
    }
    map.page.layer("grid", kHairline);
    draw_grid(map.page, map.grid);
    draw_borders(map.page, map.grid, plucked, {piece_ink(plan.piece), 0.6, {}});
    if (run.cut_off > 0) draw_borders(map.page, map.grid, cut_off, {kInk, 0.6, {}});
    map.page.layer("edge", kInk);
    draw_edge(map.page, map.grid);
    map.page.layer("notes", kInk);
    draw_names(map.page, map.grid);
    name_cells(map.page, map.grid, plucked, piece_ink(plan.piece));
    if (run.first == 1 && plan.half == Half::lower) write_labels(map, plan.piece, design);
    return map.page.finish();
}

Drawing fit_test_map(const FitTest& test, const Message& name, const FoamDesign& design) {
    // A ring has no lid: it lies as the lower half does.
    const CellTest ring = [&](int row, int column) { return test.ring(row, column) != 0; };
    const Vec3d block_mm = design.space.block_mm;
    MapPage map =
        map_page({Half::lower, test.ring.ny(), test.ring.nz(), {}, {block_mm.z, block_mm.y}}, design,
                 {name, say("sponge.ring"), say("sponge.ring_task", {{"name", design.object_name}}), kInk});
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

Drawing pluck_overview(const PluckPlan& plan, Vec2d paper, const FoamDesign& design) {
    const auto [page_mm, cell] = overview_of(plan, paper);
    const Message half = marked_side(plan.piece, plan.half);
    PageBuilder page(
        text(say("sponge.overview", {{"name", design.object_name}, {"half", half}}), design.language),
        page_mm, design.language);
    const double width = page_mm.x - 2 * kPageMargin;
    const bool with_numbers = overview_has_numbers(plan, paper);
    page.text({kPageMargin, kPageMargin + 7}, half, {kTitleText, piece_ink(plan.piece), true});
    page.text({page_mm.x - kPageMargin, kPageMargin + 7},
              shortened(design.object_name, width * 0.7, {kHeadingText, kInk, true}),
              {kHeadingText, kInk, true, TextAnchor::end});
    page.paragraph({kPageMargin, kPageMargin + 9.5}, width,
                   page.words(say(with_numbers ? "sponge.read_numbers" : "sponge.read_shades")),
                   {kBodyText, kSoftInk});

    BlockGrid grid{plan.half, plan.removed.ny(), plan.removed.nz(), {}, cell};
    grid.corner = {(page_mm.x - grid.size().x) / 2, kOverviewHead + kGridMargin};
    page.layer("pluck", piece_color(plan.piece));
    draw_depths(page, grid, plan, with_numbers);
    page.layer("edge", kInk);
    draw_edge(page, grid);
    page.layer("notes", kInk);
    draw_names(page, grid);

    const double foot = grid.corner.y + grid.size().y + kGridMargin + 6;
    draw_scale(page, plan, {kPageMargin, foot});
    page.text({page_mm.x - kPageMargin, foot + 3.8}, say("sponge.to_remove", {{"blocks", plan.plucked}}),
              {kHeadingText, piece_ink(plan.piece), true, TextAnchor::end});
    page.text({page_mm.x - kPageMargin, foot + 9},
              say("sponge.from_layers",
                  {{"layers", std::to_string(plan.layers)}, {"mm", number(plan.layer_mm, 2)}}),
              {kBodyText, kSoftInk, false, TextAnchor::end});
    return page.finish();
}

}  // namespace snug
