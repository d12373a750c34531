#include "snug/fabricate/mill/mill_setup.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "snug/base/text.h"
#include "snug/drawing/page_builder.h"
#include "snug/drawing/svg.h"
#include "snug/fabricate/kit/piece_names.h"
#include "snug/words/pieces.h"
#include "snug/words/words.h"

namespace snug {
namespace {

constexpr double kBesidePicture = 147;  // mm of the page's height
constexpr double kNames = 7;            // mm around the picture
constexpr int kMostDrawnCells = 220;

bool back_is_far(const MillPlan& plan) {
    return (plan.piece.half() == Half::lower) != plan.outside;
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
        for (const std::vector<Vec2d>& line : plan_.letters)
            for (std::size_t i = 1; i < line.size(); ++i)
                page_.line(at(line[i - 1]), at(line[i]), {kInk, 0.2, {}});
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
        const int skip = std::max(1, (std::max(ny, nx) + kMostDrawnCells - 1) / kMostDrawnCells);
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
        const Color foam = mixed(piece_color(plan_.piece), {255, 255, 255}, 0.55);
        return mixed(foam, mixed(piece_ink(plan_.piece), {0, 0, 0}, 0.35), 0.9 * depth);
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
        page_.text({corner_.x + size_.x, far ? y - 1.4 : y + 4.2}, say("mark.back"),
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

/// The programs of the cavities or of the outer sides: "lower.nc", "lower.nc and lid.nc"
std::vector<Message> programs(const MillPlans& plans, bool outside) {
    std::vector<Message> names;
    for (const MillPlan& plan : plans.plans)
        if (plan.outside == outside && !plan.empty()) names.push_back(as_it_is(mill_file_name(plan)));
    return names;
}

std::vector<Message> label_programs(const MillPlans& plans) {
    std::vector<Message> names;
    for (const MillPlan& plan : plans.plans)
        if (!plan.letters.empty()) names.push_back(as_it_is(mill_labels_name(plan.piece)));
    return names;
}

double deepest_letters(const MillPlans& plans) {
    double deepest = 0;
    for (const MillPlan& plan : plans.plans) deepest = std::max(deepest, plan.engraved_mm);
    return deepest;
}

double highest_stock(const MillPlans& plans) {
    double highest = 0;
    for (const MillPlan& plan : plans.plans) highest = std::max(highest, plan.field.top_mm());
    return highest;
}

/// How a half lies for its outer side.
Message turning(const MillPlans& plans) {
    const Message names = say("mill.programs", {{"names", programs(plans, true)}});
    if (plans.plans.front().pins.empty()) return say("mill.turn", {{"programs", names}});
    std::vector<Message> boards;
    for (const MillPlan& plan : plans.plans)
        if (plan.outside && !plan.empty()) boards.push_back(as_it_is(mill_board_name(plan.piece)));
    const bool layers = plans.layered();
    if (!layers) boards.resize(1);  // as an example
    return say("mill.turn_on_pins",
               {{"programs", names}, {"board", say("mill.programs", {{"names", boards}})}});
}

std::vector<Message> order_of_work(const MillPlans& plans, const MillOptions& options) {
    std::vector<Message> marks;
    for (const MillPlan& plan : plans.plans)
        if (!plan.outside) marks.push_back(as_it_is(piece_title(plan.piece)));
    const bool layers = plans.layered();
    std::vector<Message> steps{say("mill.cut_stock", {{"marks", marks}}),
                               say("mill.fix_stock", {{"mm", number(options.cutter_mm)}}),
                               say("mill.set_zero", {{"mm", number(highest_stock(plans) + 20, 0)}})};
    if (!plans.plans.front().pins.empty() && plans.pieces() > 1)
        steps.push_back(say(layers ? "mill.pins_layers" : "mill.pins", {{"mm", number(options.pin_mm)}}));
    if (!label_programs(plans).empty())
        steps.push_back(
            say("mill.engrave", {{"programs", say("mill.programs", {{"names", label_programs(plans)}})},
                                 {"mm", number(deepest_letters(plans), 2)}}));
    if (!programs(plans, true).empty()) steps.push_back(turning(plans));
    if (plans.pieces() == plans.plans.front().piece.count)
        steps.push_back(say(layers ? "mill.close_layers" : "mill.close"));
    return steps;
}

/// A line of a table of two columns.
void tell(PageFlow& flow, const Message& label, const Message& value) {
    flow.row({label, value}, {0, 0.3}, {});
}

std::vector<Drawing> first_pages(const FoamDesign& design, const MillPlans& plans, const MillOptions& options,
                                 const std::vector<PackFigure>& figures, Vec2d page_mm) {
    PageFlow flow(page_mm, say("mill.heading"), say("mill.subtitle", {{"name", design.object_name}}), kInk,
                  design.language);
    for (const PackFigure& figure : figures) tell(flow, figure.label, figure.value);
    tell(flow, say("mill.cutter"),
         say("mill.cutter_of",
             {{"cutter_mm", number(options.cutter_mm)}, {"flute_mm", number(options.flute_mm)}}));
    tell(flow, say("mill.feeds"),
         say("mill.feeds_of", {{"feed", number(options.feed_mm_min, 0)},
                               {"plunge", number(options.plunge_mm_min, 0)},
                               {"rpm", number(options.spindle_rpm, 0)}}));
    tell(flow, say("mill.pass"),
         say("mill.pass_of", {{"step_mm", number(plans.plans.front().field.step_mm, 3)},
                              {"apart_mm", number(options.stepover * options.cutter_mm, 2)},
                              {"safe_mm", number(options.safe_mm)}}));
    flow.heading(say("page.order_of_work"));
    flow.steps(order_of_work(plans, options), 8, kInk);
    return flow.finish();
}

std::vector<Drawing> side_page(const FoamDesign& design, const MillPlan& plan, const MillOptions& options,
                               Vec2d page_mm) {
    const Message half = marked_piece(plan.piece);
    const char* const other = plan.piece.middle() ? "mill.under" : "mill.outer";
    PageFlow flow(
        page_mm, plan.outside ? say(other, {{"half", half}}) : half,
        say("mill.from_above", {{"name", design.object_name}, {"file", "mill/" + mill_file_name(plan)}}),
        piece_ink(plan.piece), design.language);
    flow.space(kNames);
    const double picture = page_mm.y - kBesidePicture;
    const Vec2d corner = flow.room(picture + kNames);
    TopView(flow.page(), plan, corner, {flow.width(), picture}).draw(options);
    const Vec2d size = plan.field.size_mm();
    tell(flow, say("mill.lies"),
         say("mill.lies_so", {{"side", mill_side_up(plan)}, {"back", mill_back(plan)}}));
    tell(flow, say("mill.stock"),
         say("mill.stock_of", {{"size", dimensions({size.x, size.y, plan.field.top_mm()})}}));
    tell(flow, say("mill.deepest"), say("mill.deepest_of", {{"mm", number(plan.depth_mm(), 1)}}));
    tell(flow, say("figure.passes"),
         say("mill.passes_of", {{"passes", std::to_string(plan.path.levels)},
                                {"way", number(plan.path.cut_mm / 1000, 1)},
                                {"minutes", number(plan.path.minutes + 0.5, 0)}}));
    for (const MillPin& pin : plan.pins)
        tell(
            flow, say("mill.pin"),
            say("mill.pin_at",
                {{"x", number(pin.at.x, 1)}, {"y", number(pin.at.y, 1)}, {"deep", number(pin.depth_mm, 1)}}));
    return flow.finish();
}

}  // namespace

std::string mill_file_name(const MillPlan& plan) {
    return pack_stem(plan.piece) + (plan.outside ? "-outside.nc" : ".nc");
}

std::string mill_board_name(Piece piece) {
    return pack_stem(piece) + "-board.nc";
}

std::string mill_labels_name(Piece piece) {
    return pack_stem(piece) + "-labels.nc";
}

Message mill_side_up(const MillPlan& plan) {
    if (!plan.outside) return say("mill.cavity_up");
    return say(plan.piece.middle() ? "mill.under_up" : "mill.outer_up");
}

Message mill_back(const MillPlan& plan) {
    return say(back_is_far(plan) ? "mill.away" : "mill.towards");
}

DrawingDocument mill_setup(const FoamDesign& design, const MillPlans& plans, const MillOptions& options,
                           const std::vector<PackFigure>& figures, Vec2d page_mm) {
    DrawingDocument document{"mill-setup",
                             text(say("mill.title", {{"name", design.object_name}}), design.language),
                             first_pages(design, plans, options, figures, page_mm), false};
    for (const MillPlan& plan : plans.plans) {
        if (plan.empty()) continue;
        auto pages = side_page(design, plan, options, page_mm);
        std::move(pages.begin(), pages.end(), std::back_inserter(document.pages));
    }
    return document;
}

}  // namespace snug
