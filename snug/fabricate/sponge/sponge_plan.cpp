#include "snug/fabricate/sponge/sponge_plan.h"

#include <iterator>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/drawing/page_builder.h"
#include "snug/fabricate/kit/block_names.h"
#include "snug/fabricate/sponge/pluck_map.h"

namespace snug {
namespace {

constexpr double kNumberIndent = 8;  // mm
constexpr double kRowIndent = 20;

std::string many(long long count, std::string_view one, std::string_view more) {
    return counted(static_cast<unsigned long long>(count), one, more);
}

std::string stock_text(const PluckPlan& plan) {
    if (plan.layers == 0) return "no foam on this side";
    return many(plan.layers, "layer", "layers") + " of " + number(plan.column_mm * plan.removed.nz(), 1) +
           " x " + number(plan.row_mm * plan.removed.ny(), 1) + " mm, each " + number(plan.layer_mm, 2) +
           " mm thick";
}

void tell_half(PageFlow& flow, const PluckPlan& plan) {
    const TextLook name{kHeadingText, half_ink(plan.half), true};
    flow.space(2);
    flow.item(half_title(plan.half),
              stock_text(plan) + "; " + many(plan.plucked, "block", "blocks") + " to pluck", name, 22);
    const std::vector<double> shares{0.12, 0.42, 0.66};
    flow.row({"from the cavity", "pluck in each", "together"}, shares, {kSmallText, kSoftInk, true});
    for (const LayerRun& run : plan.runs) {
        if (run.plucked == 0) {
            flow.row({layers_text(run), run.cut_off > 0 ? "nothing" : "nothing: leave whole"}, shares,
                     {kBodyText, kSoftInk});
            continue;
        }
        const long long all = run.plucked * run.layers();
        flow.row({layers_text(run), many(run.plucked, "block", "blocks"),
                  grouped(static_cast<unsigned long long>(all))},
                 shares, {});
    }
}

/// The uppermost layers may be little more than what stands above the parting: less work to build than to
/// pluck.
std::string advice_on_high_columns(const PluckPlan& plan) {
    const long long columns = static_cast<long long>(plan.removed.size());
    long long kept = 0;
    int last = 0;
    for (const LayerRun& run : plan.runs)
        if (2 * run.plucked > columns) {
            kept += (columns - run.plucked - run.cut_off) * run.layers();
            last = run.last;
        }
    if (last == 0) return "";
    const bool one = last == 1;
    return std::string(half_title(plan.half)) + ": " + layers_text({1, last, 0}) +
           (one ? " keeps" : " keep") + " less than half of " + (one ? "its" : "their") + " blocks, " +
           many(kept, "block", "blocks") + (one ? "" : " together") + ". Instead of plucking " +
           (one ? "it" : "them") + ", glue as many spare blocks on layer " + std::to_string(last + 1) +
           " where the map is white: that saves work and " + many(last, "layer", "layers") + " of foam.";
}

std::vector<std::string> order_of_work(const SpongeWork& work) {
    std::vector<std::string> steps;
    if (work.test)
        steps.push_back(
            "Fit test first: print the map \"fit test\", make that ring from one layer, and pass the "
            "object's "
            "outline through it by hand. If it does not fit, go back to the design, before a whole block is "
            "spent.");
    steps.push_back(
        "Print the maps at 100 %, check the square on the first page with a ruler, and join the tiles.");
    steps.push_back(
        "Cut the layers to size. Write LOWER or LID and its number on each, and BACK on its back edge. Layer "
        "1 "
        "is the one at the cavity.");
    if (work.lower.cut_off + work.lid.cut_off > 0)
        steps.push_back(
            "Cut off each layer what its map shows in grey: the case has no room for it there. Some layers "
            "have a map for this alone.");
    steps.push_back(
        "Lay the map of a layer on it, cavity side up, BACK on BACK, the black corner on column A1. Pluck "
        "the "
        "shaded blocks. Keep them: they mend a mistake.");
    steps.push_back(
        "Stack each half from its last layer up to layer 1, the BACK edges in one line, and check the depths "
        "against the overview. Then glue the layers, with an adhesive that the object's keeper allows.");
    steps.push_back(
        "Close the empty halves once, lid over lower foam, BACK over BACK: the black corners meet and the "
        "rims "
        "touch all round.");
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
    PageFlow flow(page_mm, std::string(half_title(plan.half)) + ": depths",
                  design.object_name +
                      " · rows, then columns: blocks to remove from the cavity's side; "
                      "columns that are not named stay whole",
                  half_ink(plan.half));
    const auto text_of = [&](int from_back) { return runs_of_row(plan, plan.row_from_back(from_back)); };
    for (int begin = 0; begin < plan.removed.ny();) {
        const std::string text = text_of(begin);
        int end = begin + 1;
        while (end < plan.removed.ny() && text_of(end) == text) ++end;
        const std::string rows = row_name(begin) + (end - begin > 1 ? "-" + row_name(end - 1) : "");
        if (!text.empty()) flow.item(rows, text, {kBodyText, half_ink(plan.half), true}, kRowIndent);
        begin = end;
    }
    std::vector<Drawing> done = flow.finish();
    pages.insert(pages.end(), std::make_move_iterator(done.begin()), std::make_move_iterator(done.end()));
}

}  // namespace

std::vector<Drawing> sponge_plan(const FoamDesign& design, const SpongeWork& work, Vec2d page_mm) {
    PageFlow flow(page_mm, design.object_name,
                  "Slit sponge · " + dimensions(design.space.size()) + " mm closed (x, y, z) · blocks of " +
                      dimensions(design.space.block_mm, 2) + " mm · " +
                      many(work.lower.plucked + work.lid.plucked, "block", "blocks") + " to pluck",
                  kInk);
    tell_half(flow, work.lower);
    tell_half(flow, work.lid);
    flow.space(2);
    flow.heading("Order of work");
    int step = 0;
    for (const std::string& text : order_of_work(work))
        flow.item(std::to_string(++step), text, {kBodyText, kSoftInk, true}, kNumberIndent);
    for (const PluckPlan* plan : {&work.lower, &work.lid})
        if (const std::string advice = advice_on_high_columns(*plan); !advice.empty())
            flow.item("+", advice, {kBodyText, half_ink(plan->half), true}, kNumberIndent);
    if (work.test && (work.test->islands > 0 || work.test->pieces > 1))
        flow.paragraph("The fit test leaves out " + many(work.test->islands, "island", "islands") +
                           " of foam and its ring is in " + many(work.test->pieces, "piece", "pieces") + ".",
                       {kSmallText, kSoftInk});

    std::vector<Drawing> pages;
    for (Drawing& page : flow.finish())
        pages.push_back(titled(std::move(page), design.object_name + ": plan"));
    for (const PluckPlan* plan : {&work.lower, &work.lid})
        if (plan->plucked + plan->cut_off > 0)
            pages.push_back(pluck_overview(*plan, page_mm, design.object_name));
    for (const PluckPlan* plan : {&work.lower, &work.lid})
        if (plan->plucked > 0 && !overview_has_numbers(*plan, page_mm))
            add_table(design, *plan, page_mm, pages);
    return pages;
}

}  // namespace snug
