#include "snug/fabricate/sheets/sheet_findings.h"

#include <algorithm>
#include <utility>

#include "snug/base/text.h"
#include "snug/words/pieces.h"

namespace snug {
namespace {

constexpr std::size_t kMostNamed = 12;

Message named(const std::vector<std::string>& pieces) {
    return listed(pieces, kMostNamed);
}

void add_lost(std::vector<Finding>& findings, const FoamDesign& design, const SheetStack& stack) {
    if (stack.lost_blocks == 0) return;
    int highest = 0;
    for (const Run kept : design.seen(stack.piece).kept) highest = std::max<int>(highest, kept.end);
    const double lost = static_cast<double>(stack.lost_blocks) * design.space.block_volume();
    const int missing = highest - stack.count * stack.levels;
    std::vector<Message> lower;
    if (missing > 0)
        lower.push_back(say("sheets.ends_lower", {{"mm", number(missing * design.space.block_mm.x)},
                                                  {"levels", std::to_string(stack.levels)}}));
    findings.push_back({missing > 0 ? Severity::warning : Severity::note,
                        say("sheets-lost", {{"levels", std::to_string(stack.levels)},
                                            {"blocks", stack.lost_blocks},
                                            {"foam", foam_of(stack.piece)},
                                            {"mm3", static_cast<unsigned long long>(lost + 0.5)},
                                            {"litres", number(lost / 1e6, 2)},
                                            {"lower", lower}})});
}

/// Whether some of the piece lies on foam of the sheet before.
bool lies_on_a_sheet(const SheetStack& stack, const SheetPiece& piece) {
    if (piece.sheet == 0) return false;
    for (int row = 0; row < piece.mask.height; ++row)
        for (int column = 0; column < piece.mask.width; ++column)
            if (piece.mask.contains(column, row) &&
                stack.has(piece.row + row, piece.column + column, piece.sheet - 1))
                return true;
    return false;
}

void add_islands(std::vector<Finding>& findings, const SheetStack& stack) {
    const auto loose = island_names(stack, true), glued = island_names(stack, false);
    if (!loose.empty() && stack.piece.middle()) {
        findings.push_back({Severity::note, say("sheets-loose/middle",
                                                {{"foam", foam_of(stack.piece)}, {"pieces", named(loose)}})});
    } else if (!loose.empty()) {
        std::vector<Message> falls_out;
        if (stack.piece.half() == Half::lid) falls_out.push_back(say("sheets.falls_out"));
        findings.push_back({Severity::warning, say("sheets-loose", {{"foam", foam_of(stack.piece)},
                                                                    {"pieces", named(loose)},
                                                                    {"count", loose.size()},
                                                                    {"falls_out", falls_out}})});
    }
    if (!glued.empty())
        findings.push_back({Severity::note, say("sheets-islands",
                                                {{"foam", foam_of(stack.piece)}, {"pieces", named(glued)}})});
}

/// Sheets that are wider than the one before, as the case is.
void add_overhang(std::vector<Finding>& findings, const SheetStack& stack) {
    std::vector<char> wider(static_cast<std::size_t>(stack.count) + 1, 0);
    for (std::size_t i = 0; i < stack.missing.size(); ++i)
        if (stack.kept[i] > 0 && stack.missing[i] > 0) wider[static_cast<std::size_t>(stack.missing[i])] = 1;
    const auto count = std::count(wider.begin(), wider.end(), 1);
    if (count == 0) return;
    findings.push_back(
        {Severity::note, say(stack.piece.middle() ? "sheets-overhang/middle" : "sheets-overhang",
                             {{"sheets", count}, {"foam", foam_of(stack.piece)}})});
}

void add_dowels(std::vector<Finding>& findings, const SheetAssembly& half, const SheetOptions& options) {
    if (options.dowels == 0 || half.stack.count < 2) return;
    const std::string from = half.stack.sheet_name(half.dowels.sheets);
    const std::string last = half.stack.sheet_name(half.stack.count - 1);
    const Message foam = foam_of(half.stack.piece);
    if (half.dowels.sheets < 2)
        findings.push_back(
            {Severity::warning, say("sheets-dowels", {{"dowel_mm", number(options.dowel_mm)},
                                                      {"edge_mm", number(options.dowel_edge_mm)},
                                                      {"foam", foam}})});
    else if (half.dowels.sheets < half.stack.count)
        findings.push_back(
            {Severity::note,
             from == last ? say("sheets-dowels/one", {{"sheet", from}, {"foam", foam}})
                          : say("sheets-dowels/several", {{"first", from}, {"last", last}, {"foam", foam}})});
    else if (static_cast<int>(half.dowels.centres.size()) < options.dowels)
        findings.push_back(
            {Severity::note, say("sheets-dowels/fewer", {{"foam", foam},
                                                         {"found", half.dowels.centres.size()},
                                                         {"wanted", std::to_string(options.dowels)}})});
}

}  // namespace

std::vector<std::string> island_names(const SheetStack& stack, bool first) {
    std::vector<std::string> names;
    for (const SheetPiece& piece : stack.pieces)
        if (piece.island && lies_on_a_sheet(stack, piece) != first) names.push_back(piece.name);
    return names;
}

Message listed(const std::vector<std::string>& pieces, std::size_t most) {
    const std::size_t shown = std::min(pieces.size(), most);
    std::vector<Message> names;
    for (std::size_t i = 0; i < shown; ++i) names.push_back(as_it_is(pieces[i]));
    if (shown == pieces.size()) return say("sheets.names", {{"names", names}});
    return say("sheets.names_and_more", {{"names", names}, {"more", pieces.size() - shown}});
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
    findings.push_back({Severity::note, say("sheets-unnumbered", {{"pieces", named(pieces)}})});
}

}  // namespace snug
