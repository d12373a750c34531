#include "snug/fabricate/sheets/sheet_assembly.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "snug/base/text.h"
#include "snug/drawing/page_builder.h"
#include "snug/drawing/svg.h"
#include "snug/fabricate/sheets/sheet_drawing.h"
#include "snug/fabricate/sheets/sheet_engraving.h"
#include "snug/fabricate/sheets/sheet_findings.h"
#include "snug/words/pieces.h"

namespace snug {
namespace {

constexpr double kMargin = 15;
constexpr int kPicturesAcross = 4;
constexpr double kBetween = 6;
constexpr double kCaption = 9;            // mm below a picture
constexpr std::size_t kMostIslands = 60;  // that are named
constexpr Color kIsland{196, 60, 60};

Drawing new_page(const Message& title, Vec2d size_mm, Language language) {
    Drawing page;
    page.title = text(title, language);
    page.size_mm = size_mm;
    page.layers = {{"assembly", kInk}};
    page.language = language;
    return page;
}

void write(Drawing& page, Vec2d at, std::string text, double height, Color color = kInk, bool bold = false,
           TextAnchor anchor = TextAnchor::start) {
    page.items.push_back({0, TextItem{at, std::move(text), height, anchor, 0, bold, color}});
}

void write(Drawing& page, Vec2d at, const Message& message, double height, Color color = kInk,
           bool bold = false, TextAnchor anchor = TextAnchor::start) {
    write(page, at, text(message, page.language), height, color, bold, anchor);
}

void draw(Drawing& page, std::vector<std::vector<Vec2d>> lines, bool closed, std::optional<Color> fill,
          std::optional<Pen> pen) {
    page.items.push_back({0, PathItem{std::move(lines), closed, fill, std::move(pen)}});
}

double width_of(const Drawing& page) {
    return page.size_mm.x - 2 * kMargin;
}

/// Lines of body text; gives where the next may begin.
double paragraph(Drawing& page, double y, const std::string& mark, const Message& message) {
    constexpr double height = 3.6, indent = 8;
    if (!mark.empty()) write(page, {kMargin, y}, mark, height, kInk, true);
    const auto letters = static_cast<std::size_t>((width_of(page) - indent) / (0.53 * height));
    for (const std::string& line : wrapped(text(message, page.language), letters, 40)) {
        write(page, {kMargin + indent, y}, line, height);
        y += 1.45 * height;
    }
    return y + 1.6;
}

double heading(Drawing& page, const SheetAssembly& half, const Message& title,
               const std::string& object_name) {
    write(page, {kMargin, kMargin + 7}, title, 8, kInk, true);
    write(page, {kMargin, kMargin + 14},
          say("sheets.subtitle", {{"name", object_name}, {"mm", number(half.thickness_mm, 3)}}), 4.2,
          kSoftInk);
    return kMargin + 24;
}

/// The order of work, a step in each.
std::vector<Message> steps(const SheetAssembly& half, const SheetOptions& options) {
    const SheetStack& stack = half.stack;
    const std::string first = stack.sheet_name(0), last = stack.sheet_name(stack.count - 1);
    const auto of_piece = [&](const char* lower_code, const char* middle_code, const char* lid_code) {
        return stack.piece.middle() ? middle_code : stack.piece.highest() ? lid_code : lower_code;
    };
    std::vector<Message> steps{
        say(of_piece("sheets.lay_lower", "sheets.lay_middle", "sheets.lay_lid"), {{"first", first}})};
    if (half.dowels.sheets > 1)
        steps.push_back(say("sheets.put_dowels", {{"dowels", std::to_string(half.dowels.centres.size())},
                                                  {"mm", number(options.dowel_mm)},
                                                  {"first", first},
                                                  {"last", stack.sheet_name(half.dowels.sheets - 1)}}));
    if (options.second_color && stack.count > 1) steps.push_back(say("sheets.colors", {{"sheet", last}}));
    if (stack.count == 2) steps.push_back(say("sheets.glue_one", {{"sheet", last}}));
    if (stack.count > 2)
        steps.push_back(say("sheets.glue_all", {{"first", stack.sheet_name(1)}, {"last", last}}));
    const auto loose = island_names(stack, true), glued = island_names(stack, false);
    if (!glued.empty())
        steps.push_back(say("sheets.glue_islands", {{"islands", listed(glued, kMostIslands)}}));
    if (!loose.empty() && stack.piece.middle())
        steps.push_back(say("sheets.glue_hanging", {{"islands", listed(loose, kMostIslands)}}));
    else if (!loose.empty())
        steps.push_back(
            say("sheets.glue_loose", {{"islands", listed(loose, kMostIslands)}, {"first", first}}));
    if (options.liner_slit_mm > 0)
        steps.push_back(say("sheets.slit",
                            {{"sheet", last}, {"layer", kSlitLayer}, {"mm", number(options.liner_slit_mm)}}));
    steps.push_back(stack.piece.highest()
                        ? say("sheets.lid_done")
                        : say(of_piece("sheets.lower_done", "sheets.middle_done", ""), {{"first", first}}));
    return steps;
}

/// A length to measure in the cutter's program, and one on this page.
double scale_check(Drawing& page, double y, const ScaleCheck& check) {
    y = paragraph(page, y, "mm",
                  say("sheets.measure",
                      {{"file", check.file}, {"piece", check.piece}, {"mm", number(check.width_mm, 2)}}));
    constexpr double bar = 100;
    const double x = kMargin + 8;
    std::vector<std::vector<Vec2d>> lines{{{x, y}, {x + bar, y}}};
    for (int tick = 0; tick <= 10; ++tick)
        lines.push_back({{x + 10 * tick, y}, {x + 10 * tick, y - (tick % 5 == 0 ? 2.4 : 1.4)}});
    draw(page, std::move(lines), false, {}, Pen{kInk, 0.15, {}});
    write(page, {x + bar + 2, y}, say("sheets.bar"), 2.7, kSoftInk);
    return y + 3;
}

/// The stack from the side, the first sheet at the bottom.
void side_view(Drawing& page, double top, const SheetAssembly& half) {
    const SheetStack& stack = half.stack;
    const double room = page.size_mm.y - kMargin - top - 8, width = 90;
    const double bar = std::min(9.0, room / std::max(stack.count, 1));
    const double bottom = top + bar * stack.count;
    const int every = std::max(1, static_cast<int>(std::ceil(3.2 / bar)));
    for (int sheet = 0; sheet < stack.count; ++sheet) {
        const double y = bottom - (sheet + 1) * bar;
        draw(page,
             {{{kMargin + 20, y},
               {kMargin + 20 + width, y},
               {kMargin + 20 + width, y + bar},
               {kMargin + 20, y + bar}}},
             true, mixed(piece_color(stack.piece), {255, 255, 255}, 0.55),
             Pen{kInk, std::min(0.2, bar / 4), {}});
        if (sheet % every != 0 && sheet + 1 != stack.count) continue;
        write(page, {kMargin + 17, y + bar / 2 + 1.1}, stack.sheet_name(sheet), 3.2, kInk, true,
              TextAnchor::end);
        std::size_t pieces = 0;
        for (const SheetPiece& piece : stack.pieces) pieces += piece.sheet == sheet;
        write(page, {kMargin + 24 + width, y + bar / 2 + 1.1}, say("sheets.pieces", {{"pieces", pieces}}),
              3.2, kSoftInk);
    }
    write(page, {kMargin + 20, bottom + 5},
          say(stack.piece.middle()    ? "sheets.layer_below"
              : stack.piece.highest() ? "sheets.case_above"
                                      : "sheets.case_below"),
          3.2, kSoftInk);
}

/// One sheet small: its pieces, islands by their letters, BACK, the odd corner, dowels.
class Picture {
  public:
    Picture(Drawing& page, const SheetAssembly& half, Vec2d corner, double scale)
        : page_(page), half_(half), stack_(half.stack), corner_(corner), scale_(scale) {}

    void draw_sheet(int sheet, std::span<const SheetPiece> pieces) {
        frame();
        std::size_t islands = 0;
        for (const SheetPiece& piece : pieces) {
            outline(piece);
            islands += piece.island;
        }
        odd_corner();
        for (const SheetPiece& piece : pieces)
            if (piece.island) name_island(piece);
        if (sheet < half_.dowels.sheets)
            for (const Vec2d hole : half_.dowels.centres)
                page_.items.push_back({0, CircleItem{at(hole), std::max(0.4, 2 * scale_),
                                                     Color{255, 255, 255}, Pen{kInk, 0.15, {}}}});
        const double y = corner_.y + stack_.size_mm().y * scale_ + 4.6;
        write(page_, {corner_.x, y}, stack_.sheet_name(sheet), 4.2, kInk, true);
        if (islands > 0)
            write(page_, {corner_.x + 13, y}, say("sheets.islands", {{"islands", islands}}), 3, kIsland);
    }

  private:
    [[nodiscard]] Vec2d at(Vec2d mm) const { return corner_ + mm * scale_; }

    /// The half's rectangle, BACK thick.
    void frame() {
        const Vec2d size = stack_.size_mm();
        draw(page_, {{at({0, 0}), at({size.x, 0}), at(size), at({0, size.y})}}, true, Color{244, 245, 247},
             Pen{kSoftInk, 0.15, {0.8, 0.6}});
        const bool lower = stack_.piece.half() == Half::lower;
        const double y = lower ? 0 : size.y;
        draw(page_, {{at({0, y}), at({size.x, y})}}, false, {}, Pen{kInk, 0.6, {}});
        write(page_, at({size.x, y}) + Vec2d{0, lower ? -1.0 : 3.2}, say("mark.back"), 2.4, kInk, true,
              TextAnchor::end);
    }

    void odd_corner() {
        const double side = 2.5, down = stack_.piece.half() == Half::lower ? side : -side;
        const Vec2d corner = at({0, stack_.piece.half() == Half::lower ? 0 : stack_.size_mm().y});
        draw(page_, {{corner, corner + Vec2d{side, 0}, corner + Vec2d{0, down}}}, true, kInk, {});
    }

    void outline(const SheetPiece& piece) {
        std::vector<std::vector<Vec2d>> loops;
        for (const CellLoop& loop : piece.loops) {
            loops.emplace_back();
            for (const CellPoint p : loop)
                loops.back().push_back(
                    at({(piece.column + p.x) * stack_.cell_mm.x, (piece.row + p.y) * stack_.cell_mm.y}));
        }
        const Color color = piece_color(stack_.piece);
        draw(page_, std::move(loops), true, mixed(color, {255, 255, 255}, piece.island ? 0.1 : 0.5),
             Pen{kInk, 0.12, {}});
    }

    void name_island(const SheetPiece& piece) {
        const Vec2d middle = at({(piece.column + 0.5 * piece.mask.width) * stack_.cell_mm.x,
                                 (piece.row + 0.5 * piece.mask.height) * stack_.cell_mm.y});
        const std::string letters = piece.name.substr(stack_.sheet_name(piece.sheet).size());
        write(page_, middle + Vec2d{0, 0.7}, letters, 2, kInk, true, TextAnchor::middle);
    }

    Drawing& page_;
    const SheetAssembly& half_;
    const SheetStack& stack_;
    Vec2d corner_;
    double scale_;
};

void add_pictures(std::vector<Drawing>& pages, const SheetAssembly& half, const FoamDesign& design,
                  Vec2d page_mm) {
    const SheetStack& stack = half.stack;
    const double width = (page_mm.x - 2 * kMargin - (kPicturesAcross - 1) * kBetween) / kPicturesAcross;
    const Vec2d size = stack.size_mm();
    const double scale = std::min(width / size.x, 100 / size.y);
    const double step = size.y * scale + kCaption + kBetween;
    const int down = std::max(1, static_cast<int>((page_mm.y - 2 * kMargin - 30) / step));
    std::size_t next = 0;
    for (int sheet = 0; sheet < stack.count; ++sheet) {
        const int on_page = sheet % (down * kPicturesAcross);
        if (on_page == 0) {
            const Message name = marked_piece(stack.piece);
            pages.push_back(
                new_page(say("sheets.page_pictures", {{"half", name}}), page_mm, design.language));
            heading(pages.back(), half, say("sheets.heading_pictures", {{"half", name}}), design.object_name);
        }
        std::size_t end = next;
        while (end < stack.pieces.size() && stack.pieces[end].sheet == sheet) ++end;
        const Vec2d corner{kMargin + (on_page % kPicturesAcross) * (width + kBetween),
                           kMargin + 30 + on_page / kPicturesAcross * step};
        Picture(pages.back(), half, corner, scale)
            .draw_sheet(sheet, std::span(stack.pieces).subspan(next, end - next));
        next = end;
    }
}

}  // namespace

DrawingDocument sheet_assembly(std::span<const SheetAssembly> halves, const FoamDesign& design,
                               const SheetOptions& options, const ScaleCheck& check, Vec2d page_mm) {
    const Message title = say("sheets.title", {{"name", design.object_name}});
    DrawingDocument document{"sheets-assembly", text(title, design.language), {}, false};
    for (const SheetAssembly& half : halves) {
        const int count = half.stack.count;
        if (count == 0) continue;
        const Message name = marked_piece(half.stack.piece);
        Drawing page = new_page(say("sheets.page_order", {{"half", name}}), page_mm, design.language);
        double y = heading(page, half, say("sheets.heading_order", {{"half", name}, {"sheets", count}}),
                           design.object_name);
        int step = 0;
        for (const Message& each : steps(half, options)) y = paragraph(page, y, std::to_string(++step), each);
        y = paragraph(page, y, "!", say("sheets.laser"));
        y = scale_check(page, y, check);
        side_view(page, y + 4, half);
        document.pages.push_back(std::move(page));
        add_pictures(document.pages, half, design, page_mm);
    }
    return document;
}

}  // namespace snug
