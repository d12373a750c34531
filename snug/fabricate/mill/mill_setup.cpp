#include "snug/fabricate/mill/mill_setup.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "snug/base/text.h"
#include "snug/drawing/page_builder.h"
#include "snug/drawing/svg.h"
#include "snug/words/words.h"

namespace snug {
namespace {

constexpr double kBesidePicture = 147;  // mm of the page's height
constexpr double kNames = 7;            // mm around the picture
constexpr int kMostCells = 220;

bool back_is_far(const MillPlan& plan) {
    return (plan.half == Half::lower) != plan.outside;
}

/// A side from above, as the operator sees it: the farther, the higher on the page.
class TopView {
  public:
    TopView(PageBuilder& page, const MillPlan& plan, Vec2d corner, Vec2d room) : page_(page), plan_(plan) {
        const Vec2d size = plan.field.size_mm();
        scale_ = std::min(room.x / size.x, room.y / size.y);
        size_ = size * scale_;
        corner_ = {corner.x + (room.x - size_.x) / 2, corner.y};
    }

    void draw(const MillOptions& options) {
        depths();
        page_.rectangle(corner_, size_, {}, Pen{kInk, 0.3, {}});
        for (const MillPin& pin : plan_.pins) circle(pin.at, options.pin_mm / 2 * scale_);
        back();
        origin(options);
    }

    [[nodiscard]] double height() const { return size_.y; }

  private:
    [[nodiscard]] Vec2d at(Vec2d mm) const {
        return {corner_.x + mm.x * scale_, corner_.y + size_.y - mm.y * scale_};
    }

    /// Runs of equal depth in each row; of fine fields every so many rows and columns.
    void depths() {
        const MillField& field = plan_.field;
        const int ny = field.height.ny(), nx = field.height.nz();
        const int skip = std::max(1, (std::max(ny, nx) + kMostCells - 1) / kMostCells);
        for (int row = 0; row < ny; row += skip)
            for (int begin = 0; begin < nx;) {
                int end = begin + skip;
                while (end < nx && field.height(row, end) == field.height(row, begin)) end += skip;
                end = std::min(end, nx);
                const int last = std::min(row + skip, ny);
                const Vec2d low = at({begin * field.cell_mm.x, last * field.cell_mm.y});
                const Vec2d high = at({end * field.cell_mm.x, row * field.cell_mm.y});
                page_.rectangle(low, high - low, shade(field.height(row, begin)));
                begin = end;
            }
    }

    /// The deeper, the darker.
    [[nodiscard]] Color shade(int height) const {
        const MillField& field = plan_.field;
        const double depth =
            field.top > field.lowest() ? 1.0 * (field.top - height) / (field.top - field.lowest()) : 0;
        const Color foam = mixed(half_color(plan_.half), {255, 255, 255}, 0.55);
        return mixed(foam, mixed(half_ink(plan_.half), {0, 0, 0}, 0.35), 0.9 * depth);
    }

    void circle(Vec2d middle, double radius) {
        std::vector<Vec2d> loop;
        const double d = radius * 0.7071;
        const Vec2d c = at(middle);
        loop = {c + Vec2d{radius, 0},  c + Vec2d{d, d},   c + Vec2d{0, radius},  c + Vec2d{-d, d},
                c + Vec2d{-radius, 0}, c + Vec2d{-d, -d}, c + Vec2d{0, -radius}, c + Vec2d{d, -d}};
        page_.loops({loop}, Color{255, 255, 255}, Pen{kInk, 0.3, {}});
    }

    void back() {
        const bool far = back_is_far(plan_);
        const double y = far ? corner_.y : corner_.y + size_.y;
        page_.line({corner_.x, y}, {corner_.x + size_.x, y}, {kInk, 0.9, {}});
        page_.text({corner_.x + size_.x, far ? y - 1.4 : y + 4.2}, "BACK",
                   {kBodyText, kInk, true, TextAnchor::end});
    }

    void origin(const MillOptions& options) {
        const Vec2d size = plan_.field.size_mm();
        const Vec2d o = at(options.origin == MillOrigin::corner ? Vec2d{} : size * 0.5);
        page_.line(o, o + Vec2d{12, 0}, {kAlarm, 0.5, {}});
        page_.line(o, o + Vec2d{0, -12}, {kAlarm, 0.5, {}});
        page_.text(o + Vec2d{13, 1}, "X", {kSmallText, kAlarm, true});
        page_.text(o + Vec2d{-0.9, -13}, "Y", {kSmallText, kAlarm, true});
        page_.text(o + Vec2d{-1, 4}, "X0 Y0", {kSmallText, kAlarm, true});
    }

    PageBuilder& page_;
    const MillPlan& plan_;
    double scale_ = 1;
    Vec2d size_, corner_;
};

std::string feed_text(const MillOptions& options) {
    return number(options.feed_mm_min, 0) + " mm/min, down " + number(options.plunge_mm_min, 0) +
           " mm/min, " + number(options.spindle_rpm, 0) + " rpm: starting values, try them on waste";
}

/// "lower.nc", "lower.nc and lid.nc"
std::string programs(const MillPlans& plans, bool outside) {
    std::string names;
    for (const MillPlan& plan : plans.plans)
        if (plan.outside == outside && !plan.empty())
            names += (names.empty() ? "" : " and ") + mill_file_name(plan);
    return names;
}

double highest_stock(const MillPlans& plans) {
    double highest = 0;
    for (const MillPlan& plan : plans.plans) highest = std::max(highest, plan.field.top_mm());
    return highest;
}

/// How a half lies for its outer side.
std::string turning(const MillPlans& plans) {
    const std::string turn =
        "turn it over about the line from left to right, so that its near edge comes to "
        "lie far and its cavity down";
    const bool lower_is_turned = std::any_of(
        plans.plans.begin(), plans.plans.end(),
        [](const MillPlan& plan) { return plan.outside && plan.half == Half::lower && !plan.empty(); });
    if (plans.plans.front().pins.empty())
        return "Outer sides (" + programs(plans, true) + "): after a half's cavity is milled, " + turn +
               ", line it up by its edges, set Z0 on its top again, and run its outside program.";
    return "Outer sides (" + programs(plans, true) + "): after a half's cavity is milled, run its board " +
           "program (" + mill_board_name(lower_is_turned ? Half::lower : Half::lid) +
           ") in the board and put pins in. Take the half, " + turn +
           " on the pins, keep X0 Y0, set Z0 on its top, and run its outside program. Each half has its own "
           "holes in the board.";
}

std::vector<std::string> order_of_work(const MillPlans& plans, const MillOptions& options) {
    std::vector<std::string> steps{
        "Cut each stock to its size. Write LOWER or LID and BACK on it.",
        "Fix it on the machine, the cavity's side up and BACK as drawn: double-sided tape or a vacuum, for "
        "screws tear foam. Keep " +
            number(options.cutter_mm) + " mm free around it: strips at an edge are cleared from beside it.",
        "Set X0 Y0 where it is drawn, Z0 on the top of the stock. Run the program once with Z0 " +
            number(highest_stock(plans) + 20, 0) + " mm higher, in the air."};
    if (!plans.plans.front().pins.empty())
        steps.push_back(
            "Both cavity programs begin with two holes for pins of " + number(options.pin_mm) +
            " mm. The halves meet on them one way only: where they do not, one of them lay turned.");
    if (!programs(plans, true).empty()) steps.push_back(turning(plans));
    steps.push_back(
        "Close the empty halves once, BACK over BACK, and try the object's outline before it goes in.");
    return steps;
}

std::vector<Drawing> first_pages(const FoamDesign& design, const MillPlans& plans, const MillOptions& options,
                                 const std::vector<PackFigure>& figures, Vec2d page_mm) {
    PageFlow flow(page_mm, "Milling", design.object_name + " · set-up sheet", kInk);
    for (const PackFigure& figure : figures)
        flow.row({text(figure.label, Language::english), text(figure.value, Language::english)}, {0, 0.3},
                 {});
    flow.row(
        {"Cutter", "flat, " + number(options.cutter_mm) + " mm, flute " + number(options.flute_mm) + " mm"},
        {0, 0.3}, {});
    flow.row({"Feeds", feed_text(options)}, {0, 0.3}, {});
    flow.row({"One pass", number(plans.plans.front().field.step_mm, 3) + " mm down, lines " +
                              number(options.stepover * options.cutter_mm, 2) + " mm apart, " +
                              number(options.safe_mm) + " mm above the stock between them"},
             {0, 0.3}, {});
    flow.heading("Order of work");
    int step = 0;
    for (const std::string& words : order_of_work(plans, options))
        flow.item(std::to_string(++step), words, {kBodyText, kInk, true}, 8);
    return flow.finish();
}

std::vector<Drawing> side_page(const FoamDesign& design, const MillPlan& plan, const MillOptions& options,
                               Vec2d page_mm) {
    PageFlow flow(
        page_mm, std::string(half_title(plan.half)) + (plan.outside ? ", outer side" : ""),
        design.object_name + " · mill/" + mill_file_name(plan) + " · from above, as you stand before it",
        half_ink(plan.half));
    flow.space(kNames);
    const double picture = page_mm.y - kBesidePicture;
    const Vec2d corner = flow.room(picture + kNames);
    TopView(flow.page(), plan, corner, {flow.width(), picture}).draw(options);
    const Vec2d size = plan.field.size_mm();
    flow.row({"Lies", mill_side_up(plan) + ", BACK " + mill_back(plan)}, {0, 0.3}, {});
    flow.row({"Stock", dimensions({size.x, size.y, plan.field.top_mm()}) + " mm (right, away from you, up)"},
             {0, 0.3}, {});
    flow.row({"Deepest", number(plan.depth_mm(), 1) + " mm; the darker, the deeper"}, {0, 0.3}, {});
    flow.row({"Passes", std::to_string(plan.path.levels) + ", " + number(plan.path.cut_mm / 1000, 1) +
                            " m, about " + number(plan.path.minutes + 0.5, 0) + " minutes"},
             {0, 0.3}, {});
    for (const MillPin& pin : plan.pins)
        flow.row({"Pin", "at " + number(pin.at.x, 1) + ", " + number(pin.at.y, 1) +
                             " mm from the near left corner, " + number(pin.depth_mm, 1) + " mm deep"},
                 {0, 0.3}, {});
    return flow.finish();
}

}  // namespace

std::string mill_file_name(const MillPlan& plan) {
    return (plan.half == Half::lower ? "lower" : "lid") + std::string(plan.outside ? "-outside" : "") + ".nc";
}

std::string mill_board_name(Half half) {
    return half == Half::lower ? "lower-board.nc" : "lid-board.nc";
}

std::string mill_side_up(const MillPlan& plan) {
    return plan.outside ? "outer side up, cavity down" : "cavity up";
}

std::string mill_title(const MillPlan& plan) {
    return std::string(half_title(plan.half)) + ", " + mill_side_up(plan);
}

std::string mill_back(const MillPlan& plan) {
    return back_is_far(plan) ? "away from you" : "towards you";
}

DrawingDocument mill_setup(const FoamDesign& design, const MillPlans& plans, const MillOptions& options,
                           const std::vector<PackFigure>& figures, Vec2d page_mm) {
    DrawingDocument document{"mill-setup", design.object_name + ": milling",
                             first_pages(design, plans, options, figures, page_mm), false};
    for (const MillPlan& plan : plans.plans) {
        if (plan.empty()) continue;
        auto pages = side_page(design, plan, options, page_mm);
        std::move(pages.begin(), pages.end(), std::back_inserter(document.pages));
    }
    return document;
}

}  // namespace snug
