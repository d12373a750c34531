#include "snug/fabricate/printing/print_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace snug {
namespace {

using Column = std::pair<int, int>;

/// Blocks that fit into a length; what is a whole number but for rounding counts.
int blocks_within(double length_mm, double block_mm) {
    return static_cast<int>(std::min(std::floor(length_mm / block_mm + 1e-9), 1e6));
}

/// The farthest line within `room` of line `from`; `from` itself where there is none.
std::size_t farthest_line(const std::vector<double>& lines, std::size_t from, double room) {
    std::size_t line = from;
    while (line + 1 < lines.size() && lines[line + 1] - lines[from] <= room * (1 + 1e-9)) ++line;
    return line;
}

/// Pieces no longer than `room`, as long as they can be; none where two lines are farther apart.
std::vector<int> longest_pieces(const std::vector<double>& lines, double room) {
    std::vector<int> cuts{0};
    for (std::size_t at = 0; at + 1 < lines.size();) {
        const std::size_t next = farthest_line(lines, at, room);
        if (next == at) return {};
        cuts.push_back(static_cast<int>(at = next));
    }
    if (cuts.size() == 1) cuts.push_back(0);
    return cuts;
}

/// As many pieces, about equally long if they find room so.
std::vector<int> evened(const std::vector<int>& longest, const std::vector<double>& lines, double room) {
    const int pieces = static_cast<int>(longest.size()) - 1;
    std::vector<int> cuts{0};
    for (int i = 1; i <= pieces; ++i) {
        const double end = lines.back() * i / pieces;
        const auto from = static_cast<std::size_t>(cuts.back());
        const auto line =
            static_cast<int>(std::upper_bound(lines.begin(), lines.end(), end * (1 + 1e-9)) - lines.begin()) -
            1;
        if (line == cuts.back() || line > static_cast<int>(farthest_line(lines, from, room))) return longest;
        cuts.push_back(line);
    }
    return cuts;
}

/// Gives (j, k) and the columns that are joined to it by sides the number of their part.
void fill_part(const Grid<Run>& piece, int j, int k, int part, Grid<int>& part_at) {
    std::vector<Column> columns{{j, k}};
    part_at(j, k) = part;
    for (std::size_t next = 0; next < columns.size(); ++next) {
        const Column at = columns[next];
        for (const Column& step : {Column{-1, 0}, Column{1, 0}, Column{0, -1}, Column{0, 1}}) {
            const int j2 = at.first + step.first, k2 = at.second + step.second;
            if (!piece.contains(j2, k2) || part_at(j2, k2) >= 0) continue;
            if (!piece(j2, k2).meets(piece(at.first, at.second))) continue;
            part_at(j2, k2) = part;
            columns.push_back({j2, k2});
        }
    }
}

Grid<int> parts_by_sides(const Grid<Run>& piece) {
    Grid<int> part_at(piece.ny(), piece.nz(), -1);
    int parts = 0;
    for (int j = 0; j < piece.ny(); ++j)
        for (int k = 0; k < piece.nz(); ++k)
            if (!piece(j, k).none() && part_at(j, k) < 0) fill_part(piece, j, k, parts++, part_at);
    return part_at;
}

PrintPart part_of(const Grid<Run>& piece, const std::vector<Column>& columns, Vec3i first, int tile) {
    int j0 = piece.ny(), j1 = 0, k0 = piece.nz(), k1 = 0;
    for (const Column& at : columns) {
        j0 = std::min(j0, at.first);
        j1 = std::max(j1, at.first + 1);
        k0 = std::min(k0, at.second);
        k1 = std::max(k1, at.second + 1);
    }
    int floor = std::numeric_limits<int>::max();
    for (const Column& at : columns) floor = std::min<int>(floor, piece(at.first, at.second).first);
    PrintPart part{{first.x + floor, first.y + j0, first.z + k0}, tile, {j1 - j0, k1 - k0}};
    for (const Column& at : columns) {
        const Run run = piece(at.first, at.second);
        part.runs(at.first - j0, at.second - k0) = {static_cast<std::int16_t>(run.first - floor),
                                                    static_cast<std::int16_t>(run.end - floor)};
        part.overhangs = part.overhangs || run.first > floor;
    }
    return part;
}

/// Cuts the piece from `first` to `end` out of a half.
Grid<Run> runs_of_piece(const Grid<Run>& kept, Vec3i first, Vec3i end) {
    Grid<Run> piece(end.y - first.y, end.z - first.z);
    const auto within = [&](std::int16_t level) {
        return static_cast<std::int16_t>(std::clamp<int>(level, first.x, end.x) - first.x);
    };
    for (int j = first.y; j < end.y; ++j)
        for (int k = first.z; k < end.z; ++k) {
            const Run run{within(kept(j, k).first), within(kept(j, k).end)};
            piece(j - first.y, k - first.z) = run.none() ? Run{} : run;
        }
    return piece;
}

Grid<std::uint16_t> heights_of(const Grid<Run>& runs) {
    Grid<std::uint16_t> heights(runs.ny(), runs.nz());
    for (std::size_t i = 0; i < runs.size(); ++i) heights[i] = static_cast<std::uint16_t>(runs[i].end);
    return heights;
}

Grid<Run> from_floor(const Grid<std::uint16_t>& heights) {
    Grid<Run> runs(heights.ny(), heights.nz());
    for (std::size_t i = 0; i < runs.size(); ++i) runs[i].end = static_cast<std::int16_t>(heights[i]);
    return runs;
}

void add_parts(const Grid<Run>& kept, Vec3i first, Vec3i end, const PiecePartition& partition,
               PrintLayout& layout) {
    const Grid<Run> piece = runs_of_piece(kept, first, end);
    const int tile = static_cast<int>(layout.part_at.size()), before = static_cast<int>(layout.parts.size());
    Grid<int> part_at = partition ? partition(tile, heights_of(piece)) : parts_by_sides(piece);
    std::vector<std::vector<Column>> columns;
    for (int j = 0; j < piece.ny(); ++j)
        for (int k = 0; k < piece.nz(); ++k) {
            int& part = part_at(j, k);
            if (part < 0) continue;
            columns.resize(std::max(columns.size(), static_cast<std::size_t>(part) + 1));
            columns[static_cast<std::size_t>(part)].push_back({j, k});
            part += before;
        }
    for (const auto& own : columns) layout.parts.push_back(part_of(piece, own, first, tile));
    layout.part_at.push_back(std::move(part_at));
}

}  // namespace

int PrintPart::levels() const {
    int levels = 0;
    for (const Run run : runs) levels = std::max<int>(levels, run.end);
    return levels;
}

long long PrintPart::blocks() const {
    long long blocks = 0;
    for (const Run run : runs) blocks += run.blocks();
    return blocks;
}

bool holds_block(Vec3d bed, Vec3d block) {
    const auto fits = [](double room, double side) { return blocks_within(room, side) > 0; };
    return fits(bed.z, block.x) &&
           ((fits(bed.x, block.z) && fits(bed.y, block.y)) || (fits(bed.x, block.y) && fits(bed.y, block.z)));
}

Grid<std::uint16_t> piece_of(const Grid<std::uint16_t>& heights, Vec3i first, Vec3i end) {
    Grid<std::uint16_t> piece(end.y - first.y, end.z - first.z);
    for (int j = first.y; j < end.y; ++j)
        for (int k = first.z; k < end.z; ++k)
            piece(j - first.y, k - first.z) = static_cast<std::uint16_t>(
                std::clamp(static_cast<int>(heights(j, k)), first.x, end.x) - first.x);
    return piece;
}

BlockLines block_lines(Vec3i blocks, Vec3d block_mm) {
    BlockLines lines;
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i <= blocks[axis]; ++i)
            lines[static_cast<std::size_t>(axis)].push_back(i * block_mm[axis]);
    return lines;
}

PrintCuts print_cuts(const BlockLines& lines, Vec3d bed) {
    const auto cut = [&](std::size_t axis, double room) { return longest_pieces(lines[axis], room); };
    const auto pieces = [](const std::vector<int>& y, const std::vector<int>& z) {
        const auto count = [](const std::vector<int>& cuts) {
            return static_cast<std::int64_t>(cuts.size()) - 1;
        };
        return y.empty() || z.empty() ? std::int64_t{1} << 60 : count(y) * count(z);
    };
    PrintCuts cuts;
    cuts.turned = pieces(cut(1, bed.x), cut(2, bed.y)) < pieces(cut(1, bed.y), cut(2, bed.x));
    const double rooms[] = {bed.z, cuts.turned ? bed.x : bed.y, cuts.turned ? bed.y : bed.x};
    for (std::size_t axis = 0; axis < 3; ++axis)
        cuts.lines[axis] = evened(cut(axis, rooms[axis]), lines[axis], rooms[axis]);
    return cuts;
}

PrintCuts print_cuts(Vec3i blocks, Vec3d block, Vec3d bed) {
    return print_cuts(block_lines(blocks, block), bed);
}

namespace {

PrintLayout layout_of(const Grid<Run>& kept, PrintCuts cuts, const PiecePartition& partition) {
    PrintLayout layout;
    layout.cuts = std::move(cuts);
    const auto& lines = layout.cuts.lines;
    for (std::size_t l = 0; l + 1 < lines[0].size(); ++l)
        for (std::size_t j = 0; j + 1 < lines[1].size(); ++j)
            for (std::size_t k = 0; k + 1 < lines[2].size(); ++k)
                add_parts(kept, {lines[0][l], lines[1][j], lines[2][k]},
                          {lines[0][l + 1], lines[1][j + 1], lines[2][k + 1]}, partition, layout);
    return layout;
}

}  // namespace

PrintLayout print_layout(const Grid<std::uint16_t>& heights, PrintCuts cuts,
                         const PiecePartition& partition) {
    return layout_of(from_floor(heights), std::move(cuts), partition);
}

PrintLayout print_layout(const Grid<Run>& kept, PrintCuts cuts) {
    return layout_of(kept, std::move(cuts), {});
}

}  // namespace snug
