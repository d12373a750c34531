#include "snug/fabricate/print_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace snug {
namespace {

using Column = std::pair<int, int>;

/// Blocks that fit into a length; what is a whole number but for rounding counts.
int blocks_within(double length_mm, double block_mm) {
    return static_cast<int>(std::min(std::floor(length_mm / block_mm + 1e-9), 1e6));
}

int pieces_of(int blocks, int most) {
    return std::max(1, (blocks + most - 1) / most);
}

std::vector<int> even_lines(int blocks, int most) {
    const int pieces = pieces_of(blocks, most);
    std::vector<int> lines;
    for (int i = 0; i <= pieces; ++i) lines.push_back(static_cast<int>(std::int64_t{i} * blocks / pieces));
    return lines;
}

/// What a piece has of a half: blocks above its floor, up to its top.
Grid<std::uint16_t> piece_of(const Grid<std::uint16_t>& heights, Vec3i first, Vec3i end) {
    Grid<std::uint16_t> piece(end.y - first.y, end.z - first.z);
    for (int j = first.y; j < end.y; ++j)
        for (int k = first.z; k < end.z; ++k)
            piece(j - first.y, k - first.z) = static_cast<std::uint16_t>(
                std::clamp(static_cast<int>(heights(j, k)), first.x, end.x) - first.x);
    return piece;
}

/// The columns that are joined to (j, k) by sides, marked in `part_at`.
std::vector<Column> joined_columns(const Grid<std::uint16_t>& piece, Grid<int>& part_at, int j, int k,
                                   int part) {
    std::vector<Column> columns{{j, k}};
    part_at(j, k) = part;
    for (std::size_t next = 0; next < columns.size(); ++next) {
        const Column at = columns[next];
        for (const Column& step : {Column{-1, 0}, Column{1, 0}, Column{0, -1}, Column{0, 1}}) {
            const int j2 = at.first + step.first, k2 = at.second + step.second;
            if (!piece.contains(j2, k2) || piece(j2, k2) == 0 || part_at(j2, k2) >= 0) continue;
            part_at(j2, k2) = part;
            columns.push_back({j2, k2});
        }
    }
    return columns;
}

PrintPart part_of(const Grid<std::uint16_t>& piece, const std::vector<Column>& columns, Vec3i first,
                  int tile) {
    int j0 = piece.ny(), j1 = 0, k0 = piece.nz(), k1 = 0;
    for (const Column& at : columns) {
        j0 = std::min(j0, at.first);
        j1 = std::max(j1, at.first + 1);
        k0 = std::min(k0, at.second);
        k1 = std::max(k1, at.second + 1);
    }
    PrintPart part{{first.x, first.y + j0, first.z + k0}, tile, Grid<std::uint16_t>(j1 - j0, k1 - k0)};
    for (const Column& at : columns) part.heights(at.first - j0, at.second - k0) = piece(at.first, at.second);
    return part;
}

void add_parts(const Grid<std::uint16_t>& heights, Vec3i first, Vec3i end, PrintLayout& layout) {
    const Grid<std::uint16_t> piece = piece_of(heights, first, end);
    const int tile = static_cast<int>(layout.part_at.size());
    Grid<int> part_at(piece.ny(), piece.nz(), -1);
    for (int j = 0; j < piece.ny(); ++j)
        for (int k = 0; k < piece.nz(); ++k) {
            if (piece(j, k) == 0 || part_at(j, k) >= 0) continue;
            const auto columns = joined_columns(piece, part_at, j, k, static_cast<int>(layout.parts.size()));
            layout.parts.push_back(part_of(piece, columns, first, tile));
        }
    layout.part_at.push_back(std::move(part_at));
}

}  // namespace

int PrintPart::levels() const {
    return heights.size() == 0 ? 0 : *std::max_element(heights.begin(), heights.end());
}

long long PrintPart::blocks() const {
    return std::accumulate(heights.begin(), heights.end(), 0LL);
}

bool holds_block(Vec3d bed, Vec3d block) {
    const auto fits = [](double room, double side) { return blocks_within(room, side) > 0; };
    return fits(bed.z, block.x) &&
           ((fits(bed.x, block.z) && fits(bed.y, block.y)) || (fits(bed.x, block.y) && fits(bed.y, block.z)));
}

PrintCuts print_cuts(Vec3i blocks, Vec3d block, Vec3d bed) {
    const Vec3i straight{0, blocks_within(bed.y, block.y), blocks_within(bed.x, block.z)};
    const Vec3i turned{0, blocks_within(bed.x, block.y), blocks_within(bed.y, block.z)};
    const auto pieces = [&](Vec3i most) {
        return most.y == 0 || most.z == 0
                   ? std::int64_t{1} << 60
                   : std::int64_t{pieces_of(blocks.y, most.y)} * pieces_of(blocks.z, most.z);
    };
    PrintCuts cuts;
    cuts.turned = pieces(turned) < pieces(straight);
    const Vec3i most = cuts.turned ? turned : straight;
    cuts.lines = {even_lines(blocks.x, blocks_within(bed.z, block.x)), even_lines(blocks.y, most.y),
                  even_lines(blocks.z, most.z)};
    return cuts;
}

PrintLayout print_layout(const Grid<std::uint16_t>& heights, PrintCuts cuts) {
    PrintLayout layout;
    layout.cuts = std::move(cuts);
    const auto& lines = layout.cuts.lines;
    for (std::size_t l = 0; l + 1 < lines[0].size(); ++l)
        for (std::size_t j = 0; j + 1 < lines[1].size(); ++j)
            for (std::size_t k = 0; k + 1 < lines[2].size(); ++k)
                add_parts(heights, {lines[0][l], lines[1][j], lines[2][k]},
                          {lines[0][l + 1], lines[1][j + 1], lines[2][k + 1]}, layout);
    return layout;
}

}  // namespace snug
