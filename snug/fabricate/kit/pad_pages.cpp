#include "snug/fabricate/kit/pad_pages.h"

#include <algorithm>
#include <utility>

#include "snug/base/text.h"
#include "snug/polygon/cell_loops.h"
#include "snug/words/pieces.h"

namespace snug {
namespace {

constexpr double kBetweenPlans = 8;  // mm
constexpr double kMostPlanHeight = 80;
constexpr double kUnderPlan = 9;  // for what stands below it
constexpr Color kPadFill{214, 226, 240}, kCavity{236, 236, 232};

Half seen_from(const FillPad& pad) {
    return pad.above ? Half::lid : Half::lower;
}

/// One side of a piece, and the numbers of its pads.
struct PadPlan {
    Piece piece;
    bool above = false;
    std::vector<std::size_t> numbers;  ///< from 0
};

std::vector<PadPlan> plans_of(const FillPads& pads) {
    std::vector<PadPlan> plans;
    for (std::size_t i = 0; i < pads.pads.size(); ++i) {
        const FillPad& pad = pads.pads[i];
        auto plan = std::find_if(plans.begin(), plans.end(), [&](const PadPlan& each) {
            return each.piece == pad.piece && each.above == pad.above;
        });
        if (plan == plans.end()) plan = plans.insert(plan, {pad.piece, pad.above, {}});
        plan->numbers.push_back(i);
    }
    std::stable_sort(plans.begin(), plans.end(), [](const PadPlan& a, const PadPlan& b) {
        return a.piece.index != b.piece.index ? a.piece.index < b.piece.index : a.above < b.above;
    });
    return plans;
}

/// Where design coordinates come to lie on the page: k to the right, j downward where it is seen from above
/// and upward from below.
class PlanScale {
  public:
    PlanScale(const DesignSpace& space, bool above, Vec2d corner, double scale)
        : box_(space.box()), above_(above), corner_(corner), scale_(scale) {}
    [[nodiscard]] Vec2d size() const {
        return Vec2d{box_.max.z - box_.min.z, box_.max.y - box_.min.y} * scale_;
    }
    [[nodiscard]] Vec2d at(double y, double z) const {
        const double down = above_ ? box_.max.y - y : y - box_.min.y;
        return corner_ + Vec2d{z - box_.min.z, down} * scale_;
    }
    [[nodiscard]] std::vector<Vec2d> rectangle(Vec3d low, Vec3d high) const {
        return {at(low.y, low.z), at(low.y, high.z), at(high.y, high.z), at(high.y, low.z)};
    }

  private:
    Box3d box_;
    bool above_;
    Vec2d corner_;
    double scale_;
};

/// Columns whose foam does not end at the parting level: the cavity as it is seen.
std::vector<std::vector<Vec2d>> cavity(const PadPlan& plan, const PadPlans& all, const PlanScale& scale) {
    const Grid<Run>& foam = all.foams.piece(plan.piece);
    const auto layer = static_cast<std::size_t>(plan.above ? plan.piece.index - 1 : plan.piece.index);
    const int level = all.foams.parting[layer];
    Mask mask(foam.nz(), foam.ny());
    for (int j = 0; j < foam.ny(); ++j)
        for (int k = 0; k < foam.nz(); ++k) {
            const Run kept = foam(j, k);
            if (kept.none() || (plan.above ? kept.first != level : kept.end != level)) mask.set(k, j);
        }
    std::vector<std::vector<Vec2d>> loops;
    for (const CellLoop& loop : cell_loops(mask)) {
        std::vector<Vec2d> points;
        for (const CellPoint corner : loop)
            points.push_back(scale.at(all.space.face(1, corner.y), all.space.face(2, corner.x)));
        loops.push_back(std::move(points));
    }
    return loops;
}

void draw_plan(PageBuilder& page, const PadPlan& plan, const PadPlans& all, const PlanScale& scale) {
    const Box3d box = all.space.box();
    page.loops({scale.rectangle(box.min, box.max)}, kPaper, Pen{kSoftInk, 0.25, {}});
    page.loops(cavity(plan, all, scale), kCavity, Pen{kHairline, 0.2, {}});
    for (const std::size_t number : plan.numbers) {
        const FillPad& pad = all.pads.pads[number];
        const auto corners = scale.rectangle(pad.box.min, pad.box.max);
        page.loops({corners}, kPadFill, Pen{piece_ink(plan.piece), 0.35, {}});
        const Vec2d middle = (corners[0] + corners[2]) * 0.5;
        page.text(middle + Vec2d{0, 0.35 * kSmallText}, std::to_string(number + 1),
                  {kSmallText, kInk, true, TextAnchor::middle});
    }
    const Vec2d back = scale.at(box.min.y, box.centre().z);
    page.text(back + Vec2d{0, plan.above ? 3.4 : -1.2}, say("mark.back"),
              {kSmallText, piece_ink(plan.piece), true, TextAnchor::middle});
}

void draw_plans(PageFlow& flow, const std::vector<PadPlan>& plans, const PadPlans& all) {
    const Vec3d size = all.space.size();
    const double width = (flow.width() - kBetweenPlans) / 2;
    const double scale = std::min(width / size.z, kMostPlanHeight / size.y);
    for (std::size_t i = 0; i < plans.size(); i += 2) {
        const Vec2d corner = flow.room(size.y * scale + kUnderPlan + 4);
        for (std::size_t n = i; n < std::min(i + 2, plans.size()); ++n) {
            const double left = n == i ? 0 : width + kBetweenPlans;
            const PlanScale at(all.space, plans[n].above, corner + Vec2d{left, 4}, scale);
            draw_plan(flow.page(), plans[n], all, at);
            flow.page().text(
                corner + Vec2d{left, at.size().y + kUnderPlan + 2},
                say("packing.pads_on",
                    {{"piece", marked_side(plans[n].piece, plans[n].above ? Half::lid : Half::lower)}}),
                {kSmallText, kInk, true});
        }
    }
}

/// All are stacked from sheets of one thickness.
Message stock_text(const FillPads& pads) {
    double mm2 = 0;
    for (const FillPad& pad : pads.pads) mm2 += pad.box.size().y * pad.box.size().z * pad.sheets;
    const FillPad& first = pads.pads.front();
    return say("packing.pads_stock",
               {{"cm2", number(mm2 * 1e-2, 0)}, {"mm", number(first.thickness_mm / first.sheets, 2)}});
}

}  // namespace

Message pad_text(const FillPad& pad, const DesignSpace& space) {
    const Vec3d from = pad.box.min - space.box().min;
    return say("pad.text", {{"piece", marked_side(pad.piece, seen_from(pad))},
                            {"left", number(from.z, 1)},
                            {"back", number(from.y, 1)},
                            {"size", dimensions({pad.box.size().z, pad.box.size().y, pad.thickness_mm})},
                            {"sheets", pad.sheets},
                            {"sheet_mm", number(pad.thickness_mm / pad.sheets, 2)}});
}

void tell_pads(PageFlow& flow, const PadPlans& all) {
    if (all.pads.pads.empty()) return;
    flow.heading(say("packing.pads"));
    flow.paragraph(say("packing.pads_how"));
    flow.paragraph(stock_text(all.pads));
    draw_plans(flow, plans_of(all.pads), all);
    for (std::size_t i = 0; i < all.pads.pads.size(); ++i) {
        const FillPad& pad = all.pads.pads[i];
        Message what = pad_text(pad, all.space);
        if (!all.item_names.empty())
            what = say("summary.named", {{"name", all.item_names[pad.item]}, {"what", what}});
        flow.item(as_it_is(std::to_string(i + 1)), what, {kBodyText, kSoftInk, true}, 8);
    }
}

}  // namespace snug
