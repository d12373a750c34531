#include "snug/fabricate/sheets/sheet_findings.h"

#include <algorithm>
#include <utility>

#include "snug/base/text.h"

namespace snug {
namespace {

std::string half_name(const SheetStack& stack) {
    return stack.half == Half::lower ? "lower foam" : "lid";
}

void add(std::vector<Finding>& findings, Severity severity, std::string code, std::string message) {
    findings.push_back({severity, std::move(code), std::move(message), {}});
}

void add_lost(std::vector<Finding>& findings, const FoamDesign& design, const SheetStack& stack) {
    if (stack.lost_blocks == 0) return;
    const auto& heights = design.foams.heights(stack.half);
    int highest = 0;
    for (const auto blocks : heights) highest = std::max<int>(highest, blocks);
    const double lost = static_cast<double>(stack.lost_blocks) * design.space.block_volume();
    std::string message = "Sheets as thick as " + std::to_string(stack.levels) + " blocks take " +
                          counted(static_cast<unsigned long long>(stack.lost_blocks), "block", "blocks") +
                          " more from the " + half_name(stack) +
                          " than the design: " + grouped(static_cast<unsigned long long>(lost + 0.5)) +
                          " mm3, " + number(lost / 1e6, 2) + " litres. The object fits with more room.";
    const int missing = highest - stack.count * stack.levels;
    if (missing > 0)
        message += " At its highest the half ends " + number(missing * design.space.block_mm.x) +
                   " mm lower: choose blocks and a parting level that are multiples of " +
                   std::to_string(stack.levels) + ", or thinner sheets.";
    add(findings, missing > 0 ? Severity::warning : Severity::note, "sheets-lost", std::move(message));
}

/// Whether some of the piece lies on foam of the sheet before.
bool lies_on_a_sheet(const SheetStack& stack, const SheetPiece& piece) {
    if (piece.sheet == 0) return false;
    for (int row = 0; row < piece.mask.height; ++row)
        for (int column = 0; column < piece.mask.width; ++column)
            if (piece.mask.inside(column, row) &&
                stack.has(piece.row + row, piece.column + column, piece.sheet - 1))
                return true;
    return false;
}

void add_islands(std::vector<Finding>& findings, const SheetStack& stack) {
    const auto loose = island_names(stack, true), glued = island_names(stack, false);
    if (!loose.empty())
        add(findings, Severity::warning, "sheets-loose",
            "In the " + half_name(stack) + " the cut goes through to the case, and " + listed(loose) +
                (loose.size() == 1 ? " is" : " are") + " held by no sheet" +
                (stack.half == Half::lower ? "" : " and would fall out when the lid is lifted") +
                ": glue the first sheet's pieces onto a backing sheet, or make the space deeper.");
    if (!glued.empty())
        add(findings, Severity::note, "sheets-islands",
            "Islands of the " + half_name(stack) +
                " fall out of their sheets when cut; keep them and glue each onto the sheet before: " +
                listed(glued) + ".");
}

/// Sheets that are wider than the one before, as the case is.
void add_overhang(std::vector<Finding>& findings, const SheetStack& stack) {
    std::vector<char> wider(static_cast<std::size_t>(stack.count) + 1, 0);
    for (std::size_t i = 0; i < stack.missing.size(); ++i)
        if (stack.kept[i] > 0 && stack.missing[i] > 0) wider[static_cast<std::size_t>(stack.missing[i])] = 1;
    const auto count = static_cast<unsigned long long>(std::count(wider.begin(), wider.end(), 1));
    if (count == 0) return;
    add(findings, Severity::note, "sheets-overhang",
        "The case widens from the first sheet on, so " + counted(count, "sheet", "sheets") + " of the " +
            half_name(stack) +
            " reach over the sheet before: lay them by the dowels, or by the picture of each sheet within "
            "the "
            "dashed rectangle.");
}

void add_dowels(std::vector<Finding>& findings, const SheetAssembly& half, const SheetOptions& options) {
    if (options.dowels == 0 || half.stack.count < 2) return;
    const std::string from = half.stack.sheet_name(half.dowels.sheets);
    const std::string last = half.stack.sheet_name(half.stack.count - 1);
    if (half.dowels.sheets < 2)
        add(findings, Severity::warning, "sheets-dowels",
            "No two dowels of " + number(options.dowel_mm) + " mm with " + number(options.dowel_edge_mm) +
                " mm of foam around them go through the sheets of the " + half_name(half.stack) +
                ": lay them by the marked outlines, or choose thinner dowels.");
    else if (half.dowels.sheets < half.stack.count)
        add(findings, Severity::note, "sheets-dowels",
            (from == last ? "Sheet " + from : "Sheets " + from + " to " + last) + " of the " +
                half_name(half.stack) + (from == last ? " has" : " have") +
                " no room for dowels: lay them by the outline that is marked on the sheet before.");
    else if (static_cast<int>(half.dowels.centres.size()) < options.dowels)
        add(findings, Severity::note, "sheets-dowels",
            "The sheets of the " + half_name(half.stack) + " have room for " +
                std::to_string(half.dowels.centres.size()) + " dowels instead of " +
                std::to_string(options.dowels) + ".");
}

}  // namespace

std::vector<std::string> island_names(const SheetStack& stack, bool first) {
    std::vector<std::string> names;
    for (const SheetPiece& piece : stack.pieces)
        if (piece.island && lies_on_a_sheet(stack, piece) != first) names.push_back(piece.name);
    return names;
}

std::string listed(const std::vector<std::string>& names, std::size_t most) {
    std::string text;
    const std::size_t shown = names.size() > most ? most : names.size();
    for (std::size_t i = 0; i < shown; ++i) {
        if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
        text += names[i];
    }
    if (shown < names.size()) text += " and " + grouped(names.size() - shown) + " more";
    return text;
}

void add_sheet_findings(std::vector<Finding>& findings, const FoamDesign& design, const SheetAssembly& half,
                        const SheetOptions& options) {
    add_lost(findings, design, half.stack);
    add_islands(findings, half.stack);
    add_overhang(findings, half.stack);
    add_dowels(findings, half, options);
}

void add_unnumbered_finding(std::vector<Finding>& findings, const std::vector<std::string>& pieces) {
    if (pieces.empty()) return;
    add(findings, Severity::note, "sheets-unnumbered",
        "Too small for an engraved number, so number them by hand as they come off the cutter: " +
            listed(pieces) + ".");
}

}  // namespace snug
