#include "snug/fabricate/mould/mould_picture.h"

#include <algorithm>
#include <string>
#include <vector>

#include "snug/base/text.h"
#include "snug/drawing/svg.h"
#include "snug/drawing/text_lines.h"

namespace snug {
namespace {

constexpr double kLeastNumberCell = 4;  // mm, cells that carry a number
constexpr double kMostHeight = 165;     // mm of a page for the two views
constexpr double kBetweenViews = 6;     // mm
constexpr double kPourLabel = 24;       // mm beside the section

Color shade(const MouldPicture& picture, int core) {
    if (core == 0) return kPaper;
    const Color color = piece_color(picture.form.half);
    return mixed(mixed(color, kPaper, 0.8), mixed(color, {0, 0, 0}, 0.35),
                 static_cast<double>(core) / picture.highest);
}

void draw_core(PageBuilder& page, const MouldPicture& picture) {
    for (int core = 1; core <= picture.highest; ++core)
        draw_cells(
            page, picture.grid, [&](int row, int column) { return picture.core(row, column) == core; },
            shade(picture, core));
    draw_grid(page, picture.grid);
    draw_borders(page, picture.grid, [&](int row, int column) { return picture.core(row, column) > 0; },
                 {kInk, 0.35, {}});
    const Vec2d cell = picture.grid.cell;
    if (!picture.has_numbers()) return;
    const double height = std::min({kBodyText, cell.y * 0.5, cell.x * (picture.highest > 9 ? 0.5 : 0.6)});
    for (int row = 0; row < picture.grid.rows; ++row)
        for (int column = 0; column < picture.grid.columns; ++column)
            if (const int core = picture.core(row, column); core > 0)
                page.text(picture.grid.middle(row, column) + Vec2d{0, height * 0.36}, std::to_string(core),
                          {height, 2 * core > picture.highest ? kPaper : kInk, false, TextAnchor::middle});
}

/// Where the mould is cut apart, with the numbers of the parts that stand on the table.
void draw_parts(PageBuilder& page, const MouldPicture& picture, const Mould& mould) {
    if (mould.made.parts.size() < 2) return;
    for (std::size_t i = 0; i < mould.made.parts.size(); ++i) {
        const MouldPart& part = mould.made.parts[i];
        if (part.at_mm.z > 0) continue;
        const Vec2d corner = picture.at(part.at_mm.x, part.at_mm.y + part.size_mm.y);
        page.rectangle(corner, Vec2d{part.size_mm.x, part.size_mm.y} * picture.scale, {},
                       Pen{kAlarm, 0.5, {2, 1}});
        const double width = text_width(mould.names[i], kBodyText, true) + 2.4;
        const Vec2d label = corner + Vec2d{(part.size_mm.x * picture.scale - width) / 2, 1.2};
        page.rectangle(label, {width, kBodyText + 1.6}, kPaper, Pen{kAlarm, 0.2, {}});
        page.text(label + Vec2d{1.2, 0.4 + kBodyText}, mould.names[i], {kBodyText, kAlarm, true});
    }
}

/// Cut through the row that is marked in the view from above, and seen from the front.
void draw_section(PageBuilder& page, const MouldPicture& picture) {
    const MouldForm& form = picture.form;
    const auto& lines = form.lines[2];
    const int row = picture.grid.row_from_back(picture.section) + form.margin;
    const double pour = form.mm(0, form.pour_level), width = lines.back();
    const auto inner = [&](int k) { return form.mm(2, k); };
    const int last = static_cast<int>(lines.size()) - 1;
    page.loops(
        {{picture.in_section(inner(form.margin), pour), picture.in_section(inner(last - form.margin), pour),
          picture.in_section(inner(last - form.margin), 0), picture.in_section(inner(form.margin), 0)}},
        mixed(piece_color(form.half), kPaper, 0.75));
    std::vector<Vec2d> outline{picture.in_section(width, 0), picture.in_section(0, 0)};
    for (int k = 0; k < last; ++k)
        for (const int line : {k, k + 1})
            outline.push_back(picture.in_section(inner(line), form.mm(0, form.heights(row, k))));
    page.loops({outline}, mixed(kSoftInk, kPaper, 0.35), Pen{kInk, 0.25, {}});
    const Vec2d right = picture.in_section(width, pour), left = picture.in_section(0, pour);
    page.line(left - Vec2d{4, 0}, right + Vec2d{4, 0}, {kAlarm, 0.35, {2, 1}});
    page.text(right + Vec2d{5, 1.2}, say("mould.pour_here"), {kSmallText, kAlarm, true});
    const double marked = picture.grid.middle(picture.section, 0).y;
    for (const double x : {left.x, right.x})
        page.line({x + (x == left.x ? -1.2 : 1.2), marked}, {x + (x == left.x ? -5.0 : 5.0), marked},
                  {kInk, 0.5, {}});
    page.text({left.x - 6, marked + 1}, say("mould.section"), {kSmallText, kSoftInk, false, TextAnchor::end});
}

}  // namespace

MouldPicture::MouldPicture(const MouldForm& in_form, double width) : form(in_form) {
    const Vec3d size = form.size();
    scale = std::min((width - 2 * kPourLabel) / size.z,
                     (kMostHeight - 2 * kGridMargin - kBetweenViews) / (size.y + size.x));
    grid.half = form.half == Half::lower ? Half::lid : Half::lower;
    grid.rows = form.heights.ny() - 2 * form.margin;
    grid.columns = form.heights.nz() - 2 * form.margin;
    grid.cell = {column_mm() * scale, row_mm() * scale};
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            if (core(row, column) > highest) {
                highest = core(row, column);
                section = row;
            }
}
double MouldPicture::height() const {
    return 2 * kGridMargin + kBetweenViews + (form.size().y + form.size().x) * scale;
}

bool MouldPicture::has_numbers() const {
    return std::min(grid.cell.x, grid.cell.y) >= kLeastNumberCell;
}

Vec2d MouldPicture::in_section(double x, double up) const {
    return at(x, 0) + Vec2d{0, kGridMargin + kBetweenViews + (form.size().x - up) * scale};
}

void draw_core_scale(PageBuilder& page, const MouldPicture& picture, Vec2d at) {
    const int steps = std::min(picture.highest, 8);
    page.text(at + Vec2d{0, 3.6}, say("mould.core_scale"), {kSmallText, kSoftInk});
    for (int step = 0; step <= steps; ++step) {
        const int core = steps == 0 ? 0 : (picture.highest * step + steps / 2) / steps;
        const Vec2d corner = at + Vec2d{32.0 + 14.0 * step, 0};
        page.rectangle(corner, {14, 5}, shade(picture, core), Pen{kHairline, 0.15, {}});
        page.text(corner + Vec2d{7, 8.4}, number(core * picture.level_mm(), 1) + (step == 0 ? " mm" : ""),
                  {kSmallText, kSoftInk, false, TextAnchor::middle});
    }
}

void draw_mould(PageBuilder& page, const MouldPicture& picture, const Mould& mould) {
    const Vec3d size = picture.form.size();
    const Vec2d outer = picture.at(0, size.y);
    page.rectangle(outer, Vec2d{size.z, size.y} * picture.scale, kHairline, Pen{kInk, 0.35, {}});
    page.rectangle(picture.grid.corner, picture.grid.size(), kPaper);
    draw_core(page, picture);
    draw_edge(page, picture.grid);
    draw_parts(page, picture, mould);
    draw_section(page, picture);
}

}  // namespace snug
