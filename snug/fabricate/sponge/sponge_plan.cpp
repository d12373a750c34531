#include "snug/fabricate/sponge/sponge_plan.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/drawing/page_builder.h"
#include "snug/drawing/text_lines.h"
#include "snug/fabricate/kit/block_names.h"
#include "snug/fabricate/sponge/pluck_map.h"
#include "snug/words/pieces.h"

namespace snug {
namespace {

constexpr double kNumberIndent = 8;  // mm
constexpr double kRowIndent = 20;
constexpr double kHalfIndent = 22;  // at least
constexpr double kHalfGap = 3;

Message stock_text(const PluckPlan& plan) {
    if (plan.layers == 0) return say("sponge.no_stock", {{"blocks", plan.plucked}});
    return say("sponge.stock", {{"layers", plan.layers},
                                {"width", number(plan.column_mm * plan.removed.nz(), 1)},
                                {"depth", number(plan.row_mm * plan.removed.ny(), 1)},
                                {"mm", number(plan.layer_mm, 2)},
                                {"blocks", plan.plucked}});
}

Message blocks_text(long long blocks) {
    return say("sponge.blocks", {{"blocks", blocks}});
}

void tell_half(PageFlow& flow, const PluckPlan& plan) {
    const TextLook name{kHeadingText, piece_ink(plan.piece), true};
    double indent = kHalfIndent;
    for (int i = 0; i < plan.piece.count; ++i) {
        const std::string mark = flow.page().words(marked_piece({i, plan.piece.count}));
        indent = std::max(indent, text_width(mark, name.height_mm, true) + kHalfGap);
    }
    flow.space(2);
    flow.item(marked_piece(plan.piece), stock_text(plan), name, indent);
    const std::vector<double> shares{0.12, 0.42, 0.66};
    flow.row({say(plan.piece.middle() ? "sponge.from_above" : "sponge.from_cavity"), say("sponge.in_each"),
              say("sponge.together")},
             shares, {kSmallText, kSoftInk, true});
    for (const LayerRun& run : plan.runs) {
        if (run.plucked == 0) {
            flow.row({layers_text(run), say(run.cut_off > 0 ? "sponge.nothing" : "sponge.leave_whole")},
                     shares, {kBodyText, kSoftInk});
            continue;
        }
        const auto all = static_cast<unsigned long long>(run.plucked * run.layers());
        flow.row({layers_text(run), blocks_text(run.plucked), as_it_is(grouped(all))}, shares, {});
    }
}

/// The uppermost layers may be little more than what stands above the parting: less work to build than to
/// pluck.
std::optional<Message> advice_on_high_columns(const PluckPlan& plan) {
    if (plan.piece.middle()) return {};  // its cavities would have to be told apart
    const long long columns = static_cast<long long>(plan.removed.size());
    long long kept = 0;
    int last = 0;
    for (const LayerRun& run : plan.runs)
        if (2 * run.plucked > columns) {
            kept += (columns - run.plucked - run.cut_off) * run.layers();
            last = run.last;
        }
    if (last == 0) return {};
    const Message half = marked_piece(plan.piece);
    if (last == 1) return say("sponge.high_layer", {{"half", half}, {"blocks", kept}});
    return say("sponge.high_layers", {{"half", half},
                                      {"last", std::to_string(last)},
                                      {"blocks", kept},
                                      {"next", std::to_string(last + 1)},
                                      {"layers", last}});
}

std::vector<Message> order_of_work(const SpongeWork& work) {
    std::vector<Message> steps;
    if (!work.tests.empty()) steps.push_back(say("sponge.try_fit"));
    steps.push_back(say("sponge.print_maps"));
    std::vector<Message> marks;
    for (const PluckPlan& plan : work.plans) marks.push_back(as_it_is(piece_title(plan.piece)));
    steps.push_back(say("sponge.cut_layers", {{"marks", marks}}));
    if (cut_off_of(work) > 0) steps.push_back(say("sponge.trim"));
    steps.push_back(say("sponge.pluck"));
    if (work.plans.size() > 2) steps.push_back(say("sponge.middle"));
    steps.push_back(say("sponge.stack"));
    if (work.plans.back().piece.highest())
        steps.push_back(say(work.plans.size() > 2 ? "sponge.close_layers" : "sponge.close"));
    return steps;
}

Drawing titled(Drawing page, const std::string& title) {
    page.title = title;
    return page;
}

/// "12-15: 3   16: 2": which columns lose how many blocks. Entries are not broken across lines.
std::string runs_of_row(const PluckPlan& plan, int row) {
    std::string text;
    for (int begin = 0; begin < plan.removed.nz();) {
        int end = begin + 1;
        while (end < plan.removed.nz() && plan.removed(row, end) == plan.removed(row, begin)) ++end;
        if (plan.removed(row, begin) > 0)
            text += (text.empty() ? "" : "   ") + column_name(begin) +
                    (end - begin > 1 ? "-" + column_name(end - 1) : "") + ":\u00a0" +
                    std::to_string(plan.removed(row, begin));
        begin = end;
    }
    return text;
}

void add_table(const FoamDesign& design, const PluckPlan& plan, Vec2d page_mm, std::vector<Drawing>& pages) {
    PageFlow flow(page_mm, say("sponge.depths", {{"half", marked_side(plan.piece, plan.half)}}),
                  say("sponge.how_to_read", {{"name", design.object_name}}), piece_ink(plan.piece),
                  design.language);
    const auto text_of = [&](int from_back) { return runs_of_row(plan, plan.row_from_back(from_back)); };
    for (int begin = 0; begin < plan.removed.ny();) {
        const std::string text = text_of(begin);
        int end = begin + 1;
        while (end < plan.removed.ny() && text_of(end) == text) ++end;
        const std::string rows = row_name(begin) + (end - begin > 1 ? "-" + row_name(end - 1) : "");
        if (!text.empty())
            flow.item(as_it_is(rows), as_it_is(text), {kBodyText, piece_ink(plan.piece), true}, kRowIndent);
        begin = end;
    }
    std::vector<Drawing> done = flow.finish();
    pages.insert(pages.end(), std::make_move_iterator(done.begin()), std::make_move_iterator(done.end()));
}

/// Each piece from where it is looked at; one between two layers from above and from below.
std::vector<PluckPlan> sides_of(const SpongeWork& work) {
    std::vector<PluckPlan> sides;
    for (const PluckPlan& plan : work.plans) {
        sides.push_back(plan);
        if (plan.piece.middle()) sides.push_back(seen_from_below(plan));
    }
    return sides;
}

}  // namespace

std::string sponge_title(const FoamDesign& design) {
    return text(say("sponge.title", {{"name", design.object_name}}), design.language);
}

long long plucked_of(const SpongeWork& work) {
    long long blocks = 0;
    for (const PluckPlan& plan : work.plans) blocks += plan.plucked;
    return blocks;
}

long long cut_off_of(const SpongeWork& work) {
    long long blocks = 0;
    for (const PluckPlan& plan : work.plans) blocks += plan.cut_off;
    return blocks;
}

std::vector<Drawing> sponge_plan(const FoamDesign& design, const SpongeWork& work, Vec2d page_mm) {
    PageFlow flow(page_mm, as_it_is(design.object_name),
                  say(design.foams.open() ? "sponge.subtitle_tray" : "sponge.subtitle",
                      {{"size", dimensions(outer_size(design.foams, design.space))},
                       {"block", dimensions(design.space.block_mm, 2)},
                       {"blocks", plucked_of(work)}}),
                  kInk, design.language);
    for (const PluckPlan& plan : work.plans) tell_half(flow, plan);
    flow.space(2);
    flow.heading(say("page.order_of_work"));
    flow.steps(order_of_work(work), kNumberIndent);
    for (const PluckPlan& plan : work.plans)
        if (const auto advice = advice_on_high_columns(plan))
            flow.item(as_it_is("+"), *advice, {kBodyText, piece_ink(plan.piece), true}, kNumberIndent);
    for (const LayerTest& layer : work.tests)
        if (layer.test.islands > 0 || layer.test.pieces > 1)
            flow.paragraph(say("sponge.test_leaves_out",
                               {{"islands", layer.test.islands}, {"pieces", layer.test.pieces}}),
                           {kSmallText, kSoftInk});

    std::vector<Drawing> pages;
    for (Drawing& page : flow.finish()) pages.push_back(titled(std::move(page), sponge_title(design)));
    const std::vector<PluckPlan> sides = sides_of(work);
    for (const PluckPlan& plan : sides)
        if (plan.plucked + plan.cut_off > 0) pages.push_back(pluck_overview(plan, page_mm, design));
    for (const PluckPlan& plan : sides)
        if (plan.plucked > 0 && !overview_has_numbers(plan, page_mm)) add_table(design, plan, page_mm, pages);
    return pages;
}

}  // namespace snug
