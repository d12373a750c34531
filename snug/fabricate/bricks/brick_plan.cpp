#include "snug/fabricate/bricks/brick_plan.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "snug/base/text.h"
#include "snug/drawing/page_builder.h"
#include "snug/drawing/svg.h"
#include "snug/fabricate/bricks/brick_list.h"
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
        page_.text(corner_ + Vec2d{size().x, lower ? -1.0 : y + 3.0}, "BACK",
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
std::string pieces_text(const Step& step, const BrickColor& color) {
    std::string text;
    for (const BrickCount& each : brick_counts(step.bricks, color))
        text += (text.empty() ? "" : ", ") + std::to_string(each.pieces) + " of " +
                std::to_string(each.part->width) + "x" + std::to_string(each.part->length);
    return text;
}

std::string step_title(const Step& step, int number, int count) {
    const BrickKind kind = step.first().kind;
    const char* const what = kind == BrickKind::brick   ? "bricks"
                             : kind == BrickKind::plate ? "plates"
                                                        : "tiles";
    return "Step " + std::to_string(number) + " of " + std::to_string(count) + ": " + what;
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
    HalfPages(const ColoredBuild& half, const std::string& object_name, Vec2d paper_mm)
        : half_(half), name_(object_name), paper_(paper_mm) {
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
        PageFlow flow(paper_, std::string(half_title(half_.build->half)) + ": step by step",
                      name_ + " · from above, cavity facing you; what is put on, above what stands",
                      half_ink(half_.build->half));
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
        page.text(corner + Vec2d{0, kBodyText},
                  step_title(steps[number], static_cast<int>(number) + 1, static_cast<int>(steps.size())),
                  title);
        page.text(corner + Vec2d{0, kBodyText + 1.5 * kSmallText},
                  shortened(pieces_text(steps[number], *half_.color), width, small), small);
        CoursePicture(page, half_, corner + Vec2d{0, kCaption}, stud_)
            .draw(top_of(steps, number, *half_.build), steps[number]);
    }

    const ColoredBuild& half_;
    const std::string& name_;
    Vec2d paper_;
    int across_ = 0, down_ = 1;  // pictures on a page
    double stud_ = 0;
};

void tell_order(PageFlow& flow, const BrickPlanText& text) {
    flow.heading("Order of work");
    int step = 0;
    const auto tell = [&](const std::string& words) {
        flow.item(std::to_string(++step), words, {kBodyText, kInk, true}, 8);
    };
    tell("Sort the pieces by size. bricks/wanted.xml is the same list for a shop that takes BrickLink's.");
    tell(
        "Build each half on a flat table, course by course, its cavity facing you; bricks/foams.mpd shows "
        "the "
        "same steps in every LDraw viewer.");
    tell(
        "Press each course down before the next: joints of neighbouring courses cross, and every piece "
        "stands "
        "on those before it.");
    tell(
        "Studs stand 1.8 mm into the cavity; the design has left room for them. Line the cavity where the "
        "object must not touch hard plastic.");
    if (text.lid_gap_mm > 0)
        tell("The rims meet stud on stud, so the lid stands " + number(text.lid_gap_mm, 1) +
             " mm off. Build the rims with tiles where it must close.");
    tell("Close the empty halves once, BACK over BACK: the black corners meet.");
}

std::vector<Drawing> first_pages(std::span<const ColoredBuild> halves, const BrickPlanText& text,
                                 Vec2d paper) {
    PageFlow flow(paper, "Bricks", text.object_name + " · what to gather, and how to build it", kInk);
    for (const PackFigure& figure : text.figures)
        flow.row({snug::text(figure.label, Language::english), snug::text(figure.value, Language::english)},
                 {0, 0.32}, {});
    flow.heading("Pieces");
    const std::vector<double> shares{0, 0.14, 0.42, 0.72};
    flow.row({"pieces", "part", "name", "colour"}, shares, {kSmallText, kSoftInk, true});
    for (const BrickCount& each : brick_counts(halves))
        flow.row({grouped(static_cast<unsigned long long>(each.pieces)), std::string(each.part->number),
                  part_name(*each.part), std::string(each.color->name)},
                 shares, {});
    tell_order(flow, text);
    return flow.finish();
}

}  // namespace

BrickPlan brick_plan(std::span<const ColoredBuild> halves, const BrickPlanText& text, Vec2d paper_mm) {
    BrickPlan plan;
    plan.document = {"bricks-plan", text.object_name + ": bricks", first_pages(halves, text, paper_mm),
                     false};
    for (const ColoredBuild& half : halves) {
        if (half.build->bricks.empty()) continue;
        bool cut_short = false;
        auto pages = HalfPages(half, text.object_name, paper_mm).pages(kMostPages, cut_short);
        plan.cut_short = plan.cut_short || cut_short;
        std::move(pages.begin(), pages.end(), std::back_inserter(plan.document.pages));
    }
    return plan;
}

}  // namespace snug
