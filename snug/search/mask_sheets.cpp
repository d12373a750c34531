#include "snug/search/mask_sheets.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "snug/search/mask_rooms.h"

namespace snug {
namespace {

constexpr int kIdleRounds = 60;
constexpr int kShareOfSheets = 2;  // of the work: a half for fewer sheets, the rest to use less of each

MaskRoom sheets_of(const SheetTask& task, int sheets) {
    return {task.rows, task.columns, std::vector<int>(static_cast<std::size_t>(sheets), 0), {}};
}

const BitMask& mask_of(const MaskProblem& problem, const LaidMask& at) {
    return problem.shapes[static_cast<std::size_t>(at.shape)].mask;
}

/// A layout without clashes on so many sheets.
std::optional<MaskLayout> laid_on(MaskPacker& packer, const MaskRoom& room, long long until) {
    for (double shuffle = 0; shuffle == 0 || packer.work() < until; shuffle = 0.5) {
        MaskLayout layout = packer.laid_in_order(room, shuffle);
        if (packer.separate(room, layout, kIdleRounds, until)) return layout;
    }
    return {};
}

/// What lies on the last sheets goes to earlier ones where there is room, and to the first rows.
void move_forward(MaskPacker& packer, const MaskRoom& room, MaskLayout& layout, long long until) {
    const auto cost = [&](std::size_t, const LaidMask& at) {
        return 1LL * at.bin * room.rows + at.row + mask_of(packer.problem(), at).rows();
    };
    packer.refine(room, layout, cost, until);
}

/// The pieces of one sheet alone, in as few rows as are found.
void shorten(const MaskProblem& problem, const SheetTask& task, int sheet, MaskLayout& layout,
             long long work) {
    MaskProblem on_it;
    on_it.shapes = problem.shapes;
    on_it.gap = problem.gap;
    std::vector<std::size_t> which;
    int rows = 0;
    for (std::size_t i = 0; i < layout.size(); ++i) {
        if (layout[i].bin != sheet) continue;
        which.push_back(i);
        on_it.pieces.push_back(problem.pieces[i]);
        rows = std::max(rows, layout[i].row + mask_of(problem, layout[i]).rows());
    }
    if (which.empty()) return;
    MaskPacker packer(std::move(on_it), task.seed);
    const auto strip = shortest_strip(packer, task.columns, work);
    if (!strip || strip->rows >= rows) return;
    for (std::size_t i = 0; i < which.size(); ++i) {
        layout[which[i]] = strip->layout[i];
        layout[which[i]].bin = sheet;
    }
}

PackedSheets measured(const MaskProblem& problem, MaskLayout layout, int sheets) {
    PackedSheets packed{std::move(layout), std::vector<int>(static_cast<std::size_t>(sheets), 0)};
    for (const LaidMask& at : packed.layout) {
        int& rows = packed.rows[static_cast<std::size_t>(at.bin)];
        rows = std::max(rows, at.row + mask_of(problem, at).rows());
    }
    while (!packed.rows.empty() && packed.rows.back() == 0) packed.rows.pop_back();
    return packed;
}

}  // namespace

std::optional<PackedSheets> fewest_sheets(const MaskProblem& problem, const SheetTask& task) {
    if (task.rows < 1 || task.columns < 1 || task.most_sheets < 1) return {};
    MaskPacker packer(problem, task.seed);
    std::optional<MaskLayout> best;
    int sheets = task.most_sheets;
    const long long until = task.work / kShareOfSheets;
    for (int fewer = sheets; fewer > 0; --fewer) {
        const MaskRoom room = sheets_of(task, fewer);
        if (!packer.each_fits(room) || !may_hold(problem, room)) break;
        auto layout = laid_on(packer, room, until);
        if (!layout) break;
        move_forward(packer, room, *layout, until);
        best = std::move(layout);
        sheets = fewer;
    }
    if (!best) return {};
    for (int sheet = 0; sheet < sheets; ++sheet)
        shorten(problem, task, sheet, *best, (task.work - until) / sheets);
    return measured(problem, std::move(*best), sheets);
}

}  // namespace snug
