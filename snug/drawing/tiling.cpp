#include "snug/drawing/tiling.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "snug/drawing/clip.h"
#include "snug/drawing/page_builder.h"

namespace snug {
namespace {

constexpr double kSideMargin = 12, kTopMargin = 18, kBottomMargin = 12;  // mm, beyond any printer's own
constexpr double kCross = 3;                                             // mm, half an alignment mark
constexpr double kBar = 100;                                             // mm
constexpr double kSpare = 1e-6;  // mm that a drawing may be too long and still fit

struct Tiling {
    Vec2d paper, room;  ///< room: what a page holds of the drawing
    int columns = 1, rows = 1;

    [[nodiscard]] int count() const { return columns * rows; }
    [[nodiscard]] int number(int row, int column) const { return row * columns + column + 1; }
};

Tiling tiling(Vec2d size, Vec2d paper) {
    const Vec2d room{paper.x - 2 * kSideMargin, paper.y - kTopMargin - kBottomMargin};
    const auto tiles = [](double length, double of) {
        return std::max(1, static_cast<int>(std::ceil((length - kSpare) / of)));
    };
    return {paper, room, tiles(size.x, room.x), tiles(size.y, room.y)};
}

/// What of an item falls into the window, in the window's coordinates.
class ItemClipper {
  public:
    ItemClipper(const Window& window, Vec2d shift) : window_(window), shift_(shift) {}

    void add(const DrawingItem& item, std::vector<DrawingItem>& kept) const {
        if (const auto* path = std::get_if<PathItem>(&item.what)) {
            add(*path, item.layer, kept);
        } else if (const auto* text = std::get_if<TextItem>(&item.what)) {
            if (!window_.contains(text->at)) return;
            TextItem moved = *text;
            moved.at = moved.at + shift_;
            kept.push_back({item.layer, std::move(moved)});
        } else if (const auto* circle = std::get_if<CircleItem>(&item.what)) {
            if (!window_.contains(circle->centre)) return;
            CircleItem moved = *circle;
            moved.centre = moved.centre + shift_;
            kept.push_back({item.layer, std::move(moved)});
        }
    }

  private:
    void add(const PathItem& path, int layer, std::vector<DrawingItem>& kept) const {
        if (path.closed && path.fill) {
            PathItem fill{{}, true, path.fill, {}};
            for (const auto& loop : path.lines)
                if (auto part = clipped_loop(loop, window_); part.size() > 2)
                    fill.lines.push_back(std::move(part));
            push(std::move(fill), layer, kept);
        }
        if (!path.pen) return;
        PathItem strokes{{}, false, {}, path.pen};
        for (std::vector<Vec2d> line : path.lines) {
            if (path.closed && !line.empty()) line.push_back(line.front());
            for (auto& part : clipped_line(line, window_)) strokes.lines.push_back(std::move(part));
        }
        push(std::move(strokes), layer, kept);
    }

    void push(PathItem path, int layer, std::vector<DrawingItem>& kept) const {
        if (path.lines.empty()) return;
        for (auto& line : path.lines)
            for (Vec2d& point : line) point = point + shift_;
        kept.push_back({layer, std::move(path)});
    }

    Window window_;
    Vec2d shift_;
};

/// Something besides the lines between blocks.
bool says_anything(const Drawing& drawing, const std::vector<DrawingItem>& items) {
    return std::any_of(items.begin(), items.end(), [&](const DrawingItem& item) {
        return drawing.layers[static_cast<std::size_t>(item.layer)].name != "grid";
    });
}

/// Where a tile lies among the others: small sheets, this one dark.
void draw_page_map(PageBuilder& page, const Tiling& tiles, int row, int column) {
    const double cell = std::min({5.0, 34.0 / tiles.columns, (kTopMargin - 7) / tiles.rows});
    const Vec2d corner{tiles.paper.x - kSideMargin - cell * tiles.columns, 5};
    for (int r = 0; r < tiles.rows; ++r)
        for (int c = 0; c < tiles.columns; ++c) {
            const bool here = r == row && c == column;
            page.rectangle(corner + Vec2d{c * cell, r * cell}, {cell, cell},
                           here ? std::optional<Color>(kInk) : std::nullopt, Pen{kSoftInk, 0.15, {}});
        }
}

/// A cross on an edge that two tiles share, and the neighbour's number beyond it.
void draw_crosses(PageBuilder& page, Vec2d from, Vec2d to, Vec2d outward, int neighbour) {
    const Pen pen{kInk, 0.15, {}};
    const Vec2d along = (to - from) * (1 / length(to - from));
    for (const double share : {0.25, 0.75}) {
        const Vec2d at = from + (to - from) * share;
        page.lines({{at - Vec2d{kCross, kCross}, at + Vec2d{kCross, kCross}},
                    {at - Vec2d{kCross, -kCross}, at + Vec2d{kCross, -kCross}}},
                   pen);
        page.text(at + outward * 4.2 + along * 6 + Vec2d{0, 1}, std::to_string(neighbour),
                  {kSmallText, kSoftInk, false, TextAnchor::middle});
    }
}

void draw_bar(PageBuilder& page, Vec2d paper) {
    const double y = paper.y - 4.5, x = kSideMargin;
    std::vector<std::vector<Vec2d>> lines{{{x, y}, {x + kBar, y}}};
    for (int tick = 0; tick <= 10; ++tick) {
        const double high = tick % 5 == 0 ? 2.4 : 1.4;
        lines.push_back({{x + 10 * tick, y}, {x + 10 * tick, y - high}});
    }
    page.lines(std::move(lines), {kSoftInk, 0.15, {}});
    page.text({x + kBar + 2, y}, say("page.bar"), {kSmallText, kSoftInk});
}

Drawing tile_page(const Drawing& drawing, const Tiling& tiles, int row, int column,
                  std::vector<DrawingItem> items) {
    PageBuilder page(drawing.title, tiles.paper, drawing.language);
    const Vec2d corner{kSideMargin, kTopMargin}, end = corner + tiles.room;
    const int number = tiles.number(row, column);
    page.append(drawing.layers, std::move(items));
    page.layer("tile", kSoftInk);
    const double room = tiles.paper.x - 2 * kSideMargin - 40;
    page.text({kSideMargin, 8.5}, shortened(drawing.title, room, {kBodyText, kInk, true}),
              {kBodyText, kInk, true});
    draw_bar(page, tiles.paper);
    if (tiles.count() == 1) return page.finish();
    page.text({kSideMargin, 14},
              say("page.tile", {{"tile", std::to_string(number)}, {"tiles", std::to_string(tiles.count())}}),
              {kHeadingText, kSoftInk, true});
    draw_page_map(page, tiles, row, column);
    page.rectangle(corner, tiles.room, {}, Pen{kHairline, 0.15, {2, 1.5}});
    const Vec2d right_top{end.x, corner.y}, left_bottom{corner.x, end.y};
    if (column > 0) draw_crosses(page, corner, left_bottom, {-1, 0}, number - 1);
    if (column + 1 < tiles.columns) draw_crosses(page, right_top, end, {1, 0}, number + 1);
    if (row > 0) draw_crosses(page, corner, right_top, {0, -1}, number - tiles.columns);
    if (row + 1 < tiles.rows) draw_crosses(page, left_bottom, end, {0, 1}, number + tiles.columns);
    return page.finish();
}

}  // namespace

Result<std::vector<Drawing>> tiled(const Drawing& drawing, Vec2d paper) {
    const double least = 2 * kSideMargin + kTopMargin + kBar;
    if (std::min(paper.x, paper.y) < least) return fail(ErrorKind::usage, say("drawing.small_paper"));
    const Tiling upright = tiling(drawing.size_mm, paper),
                 across = tiling(drawing.size_mm, {paper.y, paper.x});
    const Tiling tiles = across.count() < upright.count() ? across : upright;
    std::vector<Drawing> pages;
    for (int row = 0; row < tiles.rows; ++row)
        for (int column = 0; column < tiles.columns; ++column) {
            const Vec2d from{tiles.room.x * column, tiles.room.y * row};
            const ItemClipper clipper({from, from + tiles.room}, Vec2d{kSideMargin, kTopMargin} - from);
            std::vector<DrawingItem> items;
            for (const DrawingItem& item : drawing.items) clipper.add(item, items);
            if (says_anything(drawing, items))
                pages.push_back(tile_page(drawing, tiles, row, column, std::move(items)));
        }
    return pages;
}

Drawing print_check_page(Vec2d paper, const std::string& title, Language language) {
    PageFlow flow(paper, as_it_is(title), say("page.check_first"), kInk, language);
    flow.heading(say("page.print_true"));
    flow.paragraph(say("page.measure_square"));
    flow.space(8);
    const Vec2d corner = flow.room(kBar + 10);
    flow.page().layer("check", kInk);
    flow.page().rectangle(corner, {kBar, kBar}, {}, Pen{kInk, 0.2, {}});
    const TextLook look{kBodyText, kSoftInk, false, TextAnchor::middle};
    flow.page().text(corner + Vec2d{kBar / 2, kBar / 2 + 1.2}, "100 x 100 mm", look);
    flow.page().layer("notes", kInk);
    flow.heading(say("page.join_tiles"));
    flow.paragraph(say("page.how_to_join"));
    return flow.finish().front();
}

}  // namespace snug
