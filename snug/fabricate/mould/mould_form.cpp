#include "snug/fabricate/mould/mould_form.h"

#include <algorithm>
#include <cmath>

namespace snug {
namespace {

constexpr double kLedge = 0.8;        // mm, at the pour level
constexpr double kLedgeShare = 0.25;  // of the wall, at most
constexpr double kLeastMark = 8;      // mm along both sides of the corner without a rim

/// Lines across one axis: walls of `wall` mm, split `ledge` before the blocks unless that is 0.
std::vector<double> walled_lines(int blocks, double block, double wall, double ledge) {
    std::vector<double> lines{0};
    if (ledge > 0) lines.push_back(wall - ledge);
    for (int i = 0; i <= blocks; ++i) lines.push_back(wall + i * block);
    if (ledge > 0) lines.push_back(lines.back() + ledge);
    lines.push_back(lines.back() + wall - ledge);
    return lines;
}

/// Rows or columns from the corner on in which the rim is left out.
int mark_length(const std::vector<double>& lines, int margin) {
    const int cells = static_cast<int>(lines.size()) - 1;
    int end = margin;
    while (end < cells / 2 && lines[static_cast<std::size_t>(end)] < kLeastMark) ++end;
    return end;
}

}  // namespace

MouldForm mould_form(Half half, const Grid<Run>& foam, Vec3d block, const MouldOptions& options) {
    int highest = 0;
    for (const Run kept : foam) highest = std::max<int>(highest, kept.end);
    const bool rim = options.rim_mm > 0;
    const double ledge = rim ? std::min(kLedge, options.wall_mm * kLedgeShare) : 0;
    MouldForm form;
    form.half = half;
    form.margin = rim ? 2 : 1;
    form.pour_level = highest + 1;
    form.lines = {std::vector<double>{0}, walled_lines(foam.ny(), block.y, options.wall_mm, ledge),
                  walled_lines(foam.nz(), block.z, options.wall_mm, ledge)};
    for (int i = 0; i <= highest; ++i) form.lines[0].push_back(options.wall_mm + i * block.x);
    if (rim) form.lines[0].push_back(form.lines[0].back() + options.rim_mm);

    const int ny = foam.ny() + 2 * form.margin, nz = foam.nz() + 2 * form.margin;
    form.heights = Grid<std::uint16_t>(ny, nz, static_cast<std::uint16_t>(form.pour_level));
    for (int j = 0; j < foam.ny(); ++j)
        for (int k = 0; k < foam.nz(); ++k)
            form.heights(j + form.margin, k + form.margin) =
                static_cast<std::uint16_t>(1 + highest - foam(j, k).end);
    if (!rim) return form;
    const int mark_rows = mark_length(form.lines[1], form.margin),
              mark_columns = mark_length(form.lines[2], form.margin);
    for (int j = 0; j < ny; ++j)
        for (int k = 0; k < nz; ++k) {
            const bool outermost = j == 0 || k == 0 || j == ny - 1 || k == nz - 1;
            if (outermost && !(j < mark_rows && k < mark_columns)) ++form.heights(j, k);
        }
    return form;
}

std::array<std::vector<int>, 3> cut_lines(const MouldForm& form) {
    std::array<std::vector<int>, 3> cuts;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int first = axis == 0 ? 2 : form.margin + 1,
                  last = static_cast<int>(form.lines[axis].size()) - 1;
        const int end = axis == 0 ? form.pour_level : last - form.margin;
        cuts[axis].push_back(0);
        for (int line = first; line < end; ++line) cuts[axis].push_back(line);
        cuts[axis].push_back(last);
    }
    return cuts;
}

}  // namespace snug
