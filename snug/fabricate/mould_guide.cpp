#include "snug/fabricate/mould_guide.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/fabricate/block_grid.h"
#include "snug/fabricate/page_builder.h"
#include "snug/fabricate/svg.h"
#include "snug/fabricate/text_lines.h"

namespace snug {
namespace {

constexpr double kNumberIndent = 8;      // mm
constexpr double kLeastNumberCell = 4;   // mm, cells that carry a number
constexpr double kMostShare = 0.72;      // of a page's height for a mould
constexpr std::size_t kMostListed = 60;  // parts in the guide's table; the rest are in parts.csv

std::string litres(double mm3) {
    return number(mm3 * 1e-6, 2) + " litres";
}

/// One mould from above, as a grid that lies as the other half does with its cavity up.
struct MouldPicture {
    const MouldForm& form;
    BlockGrid grid;
    double scale = 1;  ///< of the page to the mould

    MouldPicture(const MouldForm& in_form, Vec2d corner, Vec2d room) : form(in_form) {
        const Vec3d size = form.size();
        scale = std::min((room.x - 2 * kGridMargin) / size.z, (room.y - 2 * kGridMargin) / size.y);
        grid.half = form.half == Half::lower ? Half::lid : Half::lower;
        grid.rows = form.heights.ny() - 2 * form.margin;
        grid.columns = form.heights.nz() - 2 * form.margin;
        grid.cell = {column_mm() * scale, row_mm() * scale};
        const Vec2d outer = Vec2d{size.z, size.y} * scale;
        grid.corner = corner + Vec2d{(room.x - outer.x) / 2, kGridMargin} + Vec2d{wall(), wall()};
    }
    [[nodiscard]] double wall() const { return form.mm(1, form.margin) * scale; }
    [[nodiscard]] double column_mm() const { return form.mm(2, form.margin + 1) - form.mm(2, form.margin); }
    [[nodiscard]] double row_mm() const { return form.mm(1, form.margin + 1) - form.mm(1, form.margin); }
    [[nodiscard]] double level_mm() const { return form.mm(0, 2) - form.mm(0, 1); }
    /// Blocks that the core stands high.
    [[nodiscard]] int core(int row, int column) const {
        return form.heights(grid.row_from_back(row) + form.margin, column + form.margin) - 1;
    }
    [[nodiscard]] int highest() const { return form.pour_level - 1; }
    /// A place in the assembled mould (to the right, to the back) on the page.
    [[nodiscard]] Vec2d at(double x, double y) const {
        return grid.corner - Vec2d{wall(), wall()} + Vec2d{x, form.size().y - y} * scale;
    }
};

Color shade(const MouldPicture& picture, int core) {
    if (core == 0) return kPaper;
    const Color color = half_color(picture.form.half);
    return mixed(mixed(color, kPaper, 0.8), mixed(color, {0, 0, 0}, 0.35),
                 static_cast<double>(core) / picture.highest());
}

void draw_core(PageBuilder& page, const MouldPicture& picture) {
    for (int core = 1; core <= picture.highest(); ++core)
        draw_cells(
            page, picture.grid, [&](int row, int column) { return picture.core(row, column) == core; },
            shade(picture, core));
    draw_grid(page, picture.grid);
    draw_borders(page, picture.grid, [&](int row, int column) { return picture.core(row, column) > 0; },
                 {kInk, 0.35, {}});
    const Vec2d cell = picture.grid.cell;
    if (std::min(cell.x, cell.y) < kLeastNumberCell) return;
    const double height = std::min({kBodyText, cell.y * 0.5, cell.x * (picture.highest() > 9 ? 0.5 : 0.6)});
    for (int row = 0; row < picture.grid.rows; ++row)
        for (int column = 0; column < picture.grid.columns; ++column)
            if (const int core = picture.core(row, column); core > 0)
                page.text(picture.grid.middle(row, column) + Vec2d{0, height * 0.36}, std::to_string(core),
                          {height, 2 * core > picture.highest() ? kPaper : kInk, false, TextAnchor::middle});
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
        page.rectangle(corner + Vec2d{1.2, 1.2}, {width, kBodyText + 1.6}, kPaper, Pen{kAlarm, 0.2, {}});
        page.text(corner + Vec2d{2.4, 1.6 + kBodyText}, mould.names[i], {kBodyText, kAlarm, true});
    }
}

void draw_scale(PageBuilder& page, const MouldPicture& picture, Vec2d at) {
    const int steps = std::min(picture.highest(), 8);
    page.text(at + Vec2d{0, 3.6}, "Core above the floor", {kSmallText, kSoftInk});
    for (int step = 0; step <= steps; ++step) {
        const int core = steps == 0 ? 0 : (picture.highest() * step + steps / 2) / steps;
        const Vec2d corner = at + Vec2d{32.0 + 14.0 * step, 0};
        page.rectangle(corner, {14, 5}, shade(picture, core), Pen{kHairline, 0.15, {}});
        page.text(corner + Vec2d{7, 8.4}, number(core * picture.level_mm(), 1) + (step == 0 ? " mm" : ""),
                  {kSmallText, kSoftInk, false, TextAnchor::middle});
    }
}

void list_parts(PageFlow& flow, const Mould& mould) {
    if (mould.made.parts.size() < 2) return;
    flow.heading("Its parts");
    flow.paragraph(
        "Where the least corner of each stands: mm from the left, from the front and from the table.",
        {kSmallText, kSoftInk});
    const std::vector<double> shares{0, 0.2, 0.34, 0.48, 0.64};
    flow.row({"part", "left", "front", "up", "size"}, shares, {kSmallText, kSoftInk, true});
    const std::size_t listed = std::min(mould.made.parts.size(), kMostListed);
    for (std::size_t i = 0; i < listed; ++i) {
        const MouldPart& part = mould.made.parts[i];
        flow.row({mould.names[i], number(part.at_mm.x, 1), number(part.at_mm.y, 1), number(part.at_mm.z, 1),
                  dimensions(part.size_mm)},
                 shares, {});
    }
    if (listed < mould.made.parts.size())
        flow.paragraph(
            "The other " + std::to_string(mould.made.parts.size() - listed) + " are in mould/parts.csv.",
            {kSmallText, kSoftInk});
}

std::vector<Drawing> mould_pages(const FoamDesign& design, const Mould& mould, Vec2d paper) {
    const std::string name(half_title(mould.form.half));
    const Vec3d size = mould.form.size();
    PageFlow flow(paper, name + ": the mould",
                  design.object_name + " · from above, as it stands on the table · " +
                      dimensions({size.z, size.y, size.x}) + " mm · pour " + litres(mould.made.pour_mm3),
                  half_ink(mould.form.half));
    const double height =
        std::min(kMostShare * paper.y - 2 * kPageMargin, flow.width() * size.y / size.z + 2 * kGridMargin);
    const Vec2d corner = flow.room(height);
    const MouldPicture picture(mould.form, corner, {flow.width(), height});
    PageBuilder& page = flow.page();
    const Vec2d outer = picture.at(0, size.y);
    page.rectangle(outer, Vec2d{size.z, size.y} * picture.scale, kHairline, Pen{kInk, 0.35, {}});
    page.rectangle(picture.grid.corner, picture.grid.size(), kPaper);
    draw_core(page, picture);
    draw_edge(page, picture.grid);
    draw_parts(page, picture, mould);
    if (mould.made.parts.size() < 2) draw_names(page, picture.grid);
    flow.space(3);
    const Vec2d scale = flow.room(12);
    draw_scale(flow.page(), picture, scale);
    flow.paragraph(
        "The foam lies in it cavity down: the core makes the cavity, white is the foam's rim on the mould's "
        "floor. "
        "Numbers are the core's height in blocks of " +
            number(picture.level_mm(), 2) + " mm; the black corner is column A1" +
            (mould.form.margin > 1 ? ", where the mould has no rim." : "."),
        {kBodyText, kSoftInk});
    list_parts(flow, mould);
    return flow.finish();
}

std::string pour_line(const MouldForm& form) {
    const std::string height =
        number(form.mm(0, form.pour_level) - form.mm(0, 1), 1) + " mm above the mould's floor";
    return form.margin > 1 ? "the narrow ledge that runs round below the rim, " + height
                           : "the top of the walls, " + height;
}

std::vector<std::string> order_of_work(const std::vector<Mould>& moulds, const WorkshopOptions& options) {
    std::size_t parts = 0;
    int bores = 0;
    std::string pours;
    for (const Mould& mould : moulds) {
        parts += mould.made.parts.size();
        bores += mould.made.bores;
        pours += (pours.empty() ? "" : "; ") + std::string(half_title(mould.form.half)) + ": " +
                 litres(mould.made.pour_mm3) + ", to " + pour_line(mould.form);
    }
    const bool apart = parts > moulds.size();
    std::vector<std::string> steps{
        "Print each bed as it lies, without supports: nothing overhangs. Layers of 0.2 mm or finer, walls of "
        "at least three lines; "
        "the core may be filled sparsely. Write LOWER or LID on each mould."};
    if (apart)
        steps.push_back(
            std::string("Put the parts of a mould together on a flat board as its picture shows") +
            (bores > 0 ? ", with the dowels in their bores" : "") +
            ", and glue or clamp them. Seal every joint from inside with wax, modelling clay or tape: what "
            "is poured finds every gap.");
    steps.push_back(
        "Smooth what is rough, then brush all inner faces with the release agent that the foam's or "
        "silicone's maker names; "
        "printed layers hold foam fast without it.");
    steps.push_back("Level the mould. Pour " + pours +
                    ". These are litres of what has set. Foams expand many times as they rise: weigh out by "
                    "the maker's free-rise "
                    "density, less at first, and close the top with a flat greased board that lets air out, "
                    "so that the rise ends at the line.");
    steps.push_back(
        "Let it cure as long as the maker says. Trim what stands above the line flat: that is the outer side "
        "of the foam.");
    steps.push_back(
        "Write LOWER or LID on that side, and BACK along the edge that the picture marks so, before it comes "
        "out" +
        std::string(options.mould.rim_mm > 0 ? "; the corner of the mould without a rim is column A1 at BACK."
                                             : "."));
    steps.push_back(
        "Pull the foam straight up, loosening it along the walls first; or take the mould apart at its "
        "joints. "
        "Turn it over sideways, like a page: it is the half, cavity up.");
    steps.push_back(
        "Close the empty halves once, lid over lower foam, BACK over BACK: the rims touch all round.");
    return steps;
}

void tell_moulds(PageFlow& flow, const std::vector<Mould>& moulds, std::size_t beds) {
    const std::vector<double> shares{0, 0.16, 0.5, 0.62, 0.82};
    flow.row({"", "mould outside, mm", "parts", "to pour", "plastic, solid"}, shares,
             {kSmallText, kSoftInk, true});
    for (const Mould& mould : moulds) {
        const Vec3d size = mould.form.size();
        flow.row({std::string(half_title(mould.form.half)), dimensions({size.z, size.y, size.x}),
                  std::to_string(mould.made.parts.size()), litres(mould.made.pour_mm3),
                  litres(mould.made.plastic_mm3)},
                 shares, {});
    }
    flow.paragraph(
        "On " + counted(beds, "bed", "beds") + ": mould/bed-01.3mf and on, or each part on its own as STL.",
        {kSmallText, kSoftInk});
}

}  // namespace

DrawingDocument mould_guide(const FoamDesign& design, const std::vector<Mould>& moulds,
                            const WorkshopOptions& options, std::size_t beds) {
    const Vec2d paper = paper_mm(options.paper);
    const std::string title = design.object_name + ": mould guide";
    PageFlow flow(paper, design.object_name,
                  "Moulds to pour foam or silicone into · walls " + number(options.mould.wall_mm) +
                      " mm · rim " + number(options.mould.rim_mm) + " mm · draft " +
                      number(options.mould.draft_deg) + " degrees",
                  kInk);
    tell_moulds(flow, moulds, beds);
    flow.space(2);
    flow.heading("Order of work");
    int step = 0;
    for (const std::string& text : order_of_work(moulds, options))
        flow.item(std::to_string(++step), text, {kBodyText, kSoftInk, true}, kNumberIndent);
    DrawingDocument document{"mould-guide", title, flow.finish(), false};
    for (const Mould& mould : moulds) {
        std::vector<Drawing> pages = mould_pages(design, mould, paper);
        document.pages.insert(document.pages.end(), std::make_move_iterator(pages.begin()),
                              std::make_move_iterator(pages.end()));
    }
    for (Drawing& page : document.pages) page.title = title;
    return document;
}

}  // namespace snug
