#include "snug/fabricate/bricks/brick_plan.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "snug/base/text.h"
#include "snug/drawing/page_builder.h"
#include "snug/drawing/svg.h"
#include "snug/fabricate/bricks/brick_list.h"
#include "snug/words/pieces.h"
#include "snug/words/words.h"

namespace snug {
namespace {

constexpr std::size_t kMostPages = 300;
constexpr double kReadableStud = 3.2;  // mm on paper
constexpr double kGreatestStud = 6;
constexpr double kPageHead = 24;      // mm that the title takes
constexpr double kBelow = 5;          // mm below a picture
constexpr double kBetween = 8;        // mm between pictures
constexpr double kCaption = 13;       // mm above a picture
constexpr double kLeastLabelled = 2;  // mm of a stud on paper that leave room for a size
constexpr Color kStanding{226, 229, 234};

/// Bricks that are put on between two STEPs of the LDraw file.
struct Step {
    std::span<const Brick> bricks;
    [[nodiscard]] const Brick& first() const { return bricks.front(); }
};

std::vector<Step> steps_of(const BrickBuild& build) {
    std::vector<Step> steps;
    const std::span<const Brick> all(build.bricks);
    for (std::size_t begin = 0; begin < all.size();) {
        std::size_t end = begin + 1;
        while (end < all.size() && all[end].bottom == all[begin].bottom && all[end].kind == all[begin].kind)
            ++end;
        steps.push_back({all.subspan(begin, end - begin)});
        begin = end;
    }
    return steps;
}

Color paint(const BrickColor& color) {
    return {color.red, color.green, color.blue};
}

/// Light enough for black letters.
Color pale(const BrickColor& color) {
    return mixed(paint(color), {255, 255, 255}, 0.55);
}

/// A course from above, with what already stands below it.
class CoursePicture {
  public:
    CoursePicture(PageBuilder& page, const ColoredBuild& half, Vec2d corner, double stud_mm)
        : page_(page), half_(half), corner_(corner), stud_(stud_mm) {}

    void draw(const Grid<char>& standing, const Step& step) {
        frame();
        for (int row = 0; row < standing.ny(); ++row)
            for (int column = 0; column < standing.nz();) {
                int end = column;
                while (end < standing.nz() && standing(row, end)) ++end;
                if (end > column)
                    page_.rectangle(at(row, column), Vec2d{(end - column) * stud_, stud_}, kStanding);
                column = std::max(end, column + 1);
            }
        for (const Brick& brick : step.bricks) piece(brick);
        edge();
    }

  private:
    [[nodiscard]] Vec2d at(int row, int column) const { return corner_ + Vec2d{column * stud_, row * stud_}; }
    [[nodiscard]] Vec2d size() const { return {half_.build->columns * stud_, half_.build->rows * stud_}; }

    void frame() { page_.rectangle(corner_, size(), Color{255, 255, 255}, Pen{kHairline, 0.15, {}}); }

    void piece(const Brick& brick) {
        const double inset = 0.05 * stud_;
        const Vec2d corner = at(brick.row, brick.column) + Vec2d{inset, inset};
        const Vec2d size{brick.columns * stud_ - 2 * inset, brick.rows * stud_ - 2 * inset};
        page_.rectangle(corner, size, pale(*half_.color), Pen{kInk, 0.14, {}});
        if (brick.studs() < 2 || stud_ < kLeastLabelled) return;
        const std::string label = std::to_string(std::min(brick.rows, brick.columns)) + "×" +
                                  std::to_string(std::max(brick.rows, brick.columns));
        const double height = std::min(0.52 * stud_, 2.6);
        const bool upright = brick.rows > brick.columns;
        const Vec2d middle = corner + size * 0.5;
        const TextLook look{height, kInk, false, TextAnchor::middle};
        if (upright)
            page_.text(middle + Vec2d{0.35 * height, 0}, label, look, 270);
        else
            page_.text(middle + Vec2d{0, 0.35 * height}, label, look);
    }

    /// BACK is drawn thick and named; the corner of column A1 is black.
    void edge() {
        const bool lower = half_.build->half == Half::lower;
        const double y = lower ? 0 : size().y;
        page_.line(corner_ + Vec2d{0, y}, corner_ + Vec2d{size().x, y}, {kInk, 0.6, {}});
        page_.text(corner_ + Vec2d{size().x, lower ? -1.0 : y + 3.0}, say("mark.back"),
                   {kSmallText, kInk, true, TextAnchor::end});
        const double side = std::min(2.5, stud_), down = lower ? side : -side;
        const Vec2d odd = corner_ + Vec2d{0, y};
        page_.loops({{odd, odd + Vec2d{side, 0}, odd + Vec2d{0, down}}}, kInk);
    }

    PageBuilder& page_;
    const ColoredBuild& half_;
    Vec2d corner_;
    double stud_;
};

/// "4 of 2x10, 1 of 1x3"
Message pieces_text(const Step& step, const BrickColor& color) {
    std::vector<Message> counts;
    for (const BrickCount& each : brick_counts(step.bricks, color))
        counts.push_back(say("bricks.count", {{"pieces", std::to_string(each.pieces)},
                                              {"size", std::to_string(each.part->width) + "x" +
                                                           std::to_string(each.part->length)}}));
    return say("bricks.counts", {{"counts", counts}});
}

Message step_title(const Step& step, std::size_t number, std::size_t count) {
    const BrickKind kind = step.first().kind;
    return say(kind == BrickKind::brick   ? "bricks.step_bricks"
               : kind == BrickKind::plate ? "bricks.step_plates"
                                          : "bricks.step_tiles",
               {{"step", std::to_string(number)}, {"steps", std::to_string(count)}});
}

void mark(Grid<char>& standing, const Step& step) {
    for (const Brick& brick : step.bricks)
        for (int row = brick.row; row < brick.row + brick.rows; ++row)
            for (int column = brick.column; column < brick.column + brick.columns; ++column)
                standing(row, column) = 1;
}

/// Studs that nothing stands on any more are lower than the course: only what it is put on is shown.
Grid<char> top_of(const std::vector<Step>& steps, std::size_t number, const BrickBuild& build) {
    Grid<char> standing(build.rows, build.columns);
    const int bottom = steps[number].first().bottom;
    for (std::size_t i = 0; i < number; ++i)
        if (steps[i].first().top() >= bottom) mark(standing, steps[i]);
    return standing;
}

class HalfPages {
  public:
    HalfPages(const ColoredBuild& half, const BrickPlanText& text, Vec2d paper_mm)
        : half_(half), text_(text), paper_(paper_mm) {
        // As many pictures on a page as stay easy to read.
        for (const int across : {1, 2, 3})
            for (const int down : {1, 2, 3, 4}) {
                const double stud = stud_for(across, down);
                const bool better =
                    across_ == 0 || (stud >= kReadableStud && across * down > across_ * down_);
                if (!better) continue;
                across_ = across;
                down_ = down;
                stud_ = stud;
            }
    }

    [[nodiscard]] std::vector<Drawing> pages(std::size_t most, bool& cut_short) {
        const std::vector<Step> steps = steps_of(*half_.build);
        PageFlow flow(paper_, say("bricks.steps", {{"half", marked_piece(half_.build->half)}}),
                      say("bricks.how_to_read", {{"name", text_.object_name}}), piece_ink(half_.build->half),
                      text_.language);
        const auto across = static_cast<std::size_t>(across_), down = static_cast<std::size_t>(down_);
        for (std::size_t first = 0; first < steps.size(); first += across) {
            cut_short = first / (across * down) >= most;
            if (cut_short) break;
            const Vec2d corner = flow.room(kCaption + half_.build->rows * stud_ + kBelow);
            for (std::size_t i = first; i < std::min(first + across, steps.size()); ++i)
                draw(flow.page(), corner + Vec2d{static_cast<double>(i - first) * column_width(), 0}, steps,
                     i);
        }
        return flow.finish();
    }

  private:
    [[nodiscard]] double stud_for(int across, int down) const {
        const double width = (paper_.x - 2 * kPageMargin + kBetween) / across - kBetween;
        const double height = (paper_.y - 2 * kPageMargin - kPageHead) / down - kCaption - kBelow;
        return std::min({kGreatestStud, width / half_.build->columns, height / half_.build->rows});
    }
    [[nodiscard]] double column_width() const { return (paper_.x - 2 * kPageMargin + kBetween) / across_; }

    void draw(PageBuilder& page, Vec2d corner, const std::vector<Step>& steps, std::size_t number) {
        const double width = column_width() - kBetween;
        const TextLook title{kBodyText, kInk, true}, small{kSmallText, kSoftInk};
        page.text(corner + Vec2d{0, kBodyText}, step_title(steps[number], number + 1, steps.size()), title);
        page.text(corner + Vec2d{0, kBodyText + 1.5 * kSmallText},
                  shortened(page.words(pieces_text(steps[number], *half_.color)), width, small), small);
        CoursePicture(page, half_, corner + Vec2d{0, kCaption}, stud_)
            .draw(top_of(steps, number, *half_.build), steps[number]);
    }

    const ColoredBuild& half_;
    const BrickPlanText& text_;
    Vec2d paper_;
    int across_ = 0, down_ = 1;  // pictures on a page
    double stud_ = 0;
};

void tell_order(PageFlow& flow, const BrickPlanText& text) {
    std::vector<Message> steps{say("bricks.sort"), say("bricks.build"), say("bricks.press"),
                               say("bricks.studs")};
    if (text.lid_gap_mm > 0) steps.push_back(say("bricks.lid_gap", {{"mm", number(text.lid_gap_mm, 1)}}));
    if (text.closes) steps.push_back(say("bricks.close"));
    flow.heading(say("page.order_of_work"));
    flow.steps(steps, 8, kInk);
}

std::vector<Drawing> first_pages(std::span<const ColoredBuild> halves, const BrickPlanText& text,
                                 Vec2d paper) {
    PageFlow flow(paper, say("bricks.heading"), say("bricks.subtitle", {{"name", text.object_name}}), kInk,
                  text.language);
    for (const PackFigure& figure : text.figures) flow.row({figure.label, figure.value}, {0, 0.32}, {});
    flow.heading(say("bricks.pieces"));
    const std::vector<double> shares{0, 0.14, 0.42, 0.72};
    flow.row({say("bricks.column_pieces"), say("bricks.column_part"), say("bricks.column_name"),
              say("bricks.column_colour")},
             shares, {kSmallText, kSoftInk, true});
    for (const BrickCount& each : brick_counts(halves))
        flow.row({as_it_is(grouped(static_cast<unsigned long long>(each.pieces))),
                  as_it_is(each.part->number), part_name(*each.part), color_name(*each.color)},
                 shares, {});
    tell_order(flow, text);
    return flow.finish();
}

}  // namespace

BrickPlan brick_plan(std::span<const ColoredBuild> halves, const BrickPlanText& text, Vec2d paper_mm) {
    BrickPlan plan;
    const Message title = say("bricks.title", {{"name", text.object_name}});
    plan.document = {"bricks-plan", snug::text(title, text.language), first_pages(halves, text, paper_mm),
                     false};
    for (const ColoredBuild& half : halves) {
        if (half.build->bricks.empty()) continue;
        bool cut_short = false;
        auto pages = HalfPages(half, text, paper_mm).pages(kMostPages, cut_short);
        plan.cut_short = plan.cut_short || cut_short;
        std::move(pages.begin(), pages.end(), std::back_inserter(plan.document.pages));
    }
    return plan;
}

}  // namespace snug
