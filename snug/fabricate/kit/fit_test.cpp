#include "snug/fabricate/kit/fit_test.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace snug {
namespace {

using Place = std::pair<int, int>;

Grid<char> columns_cut_at(const BlockMap& blocks, int level) {
    Grid<char> cut(blocks.ny(), blocks.nz(), 0);
    for (std::size_t column = 0; column < blocks.size(); ++column)
        cut[column] = blocks[column].first <= level && level < blocks[column].end ? 1 : 0;
    return cut;
}

/// The columns of `value` that are joined to (j, k) by sides, taken out of `open`.
std::vector<Place> piece_at(Grid<char>& open, int j, int k) {
    std::vector<Place> piece{{j, k}};
    open(j, k) = 0;
    for (std::size_t next = 0; next < piece.size(); ++next) {
        const Place at = piece[next];
        for (const Place& step : {Place{-1, 0}, Place{1, 0}, Place{0, -1}, Place{0, 1}}) {
            const int j2 = at.first + step.first, k2 = at.second + step.second;
            if (!open.contains(j2, k2) || !open(j2, k2)) continue;
            open(j2, k2) = 0;
            piece.push_back({j2, k2});
        }
    }
    return piece;
}

/// Visits each piece of the columns that `mask` marks.
template <class Visit>
void for_each_piece(Grid<char> mask, Visit visit) {
    for (int j = 0; j < mask.ny(); ++j)
        for (int k = 0; k < mask.nz(); ++k)
            if (mask(j, k)) visit(piece_at(mask, j, k));
}

Grid<char> inverted(Grid<char> mask) {
    for (char& cell : mask) cell = cell ? 0 : 1;
    return mask;
}

/// Islands of foam become part of the opening; gives how many there were.
int fill_islands(Grid<char>& opening) {
    int islands = 0;
    for_each_piece(inverted(opening), [&](const std::vector<Place>& piece) {
        const bool at_the_rim = std::any_of(piece.begin(), piece.end(), [&](Place at) {
            return at.first == 0 || at.second == 0 || at.first == opening.ny() - 1 ||
                   at.second == opening.nz() - 1;
        });
        if (at_the_rim) return;
        ++islands;
        for (const Place& at : piece) opening(at.first, at.second) = 1;
    });
    return islands;
}

/// Marks grow by `reach` cells along one axis.
Grid<char> spread(const Grid<char>& mask, int reach, bool along_y) {
    Grid<char> result(mask.ny(), mask.nz(), 0);
    const int lines = along_y ? mask.nz() : mask.ny(), length = along_y ? mask.ny() : mask.nz();
    const auto at = [&](int line, int i) { return along_y ? mask.index(i, line) : mask.index(line, i); };
    for (int line = 0; line < lines; ++line) {
        int last = -length - reach;
        for (int i = 0; i < length + reach; ++i) {
            if (i < length && mask[at(line, i)]) last = i;
            const int behind = i - reach;
            if (behind >= 0 && behind < length && last >= behind - reach) result[at(line, behind)] = 1;
        }
    }
    return result;
}

int cells_for(double mm, double cell_mm) {
    return std::max(1, static_cast<int>(std::ceil(mm / cell_mm - 1e-9)));
}

}  // namespace

std::optional<FitTest> fit_test(const FoamDesign& design, double least_ring_mm, int layer) {
    const auto count = [](const Grid<char>& mask) { return std::count(mask.begin(), mask.end(), 1); };
    const auto at = static_cast<std::size_t>(layer) - 1;
    const int parting = design.foams.parting[at];
    const BlockMap& blocks = design.layers[at];
    FitTest test;
    test.level = parting - 1;
    test.opening = columns_cut_at(blocks, parting - 1);
    Grid<char> above = columns_cut_at(blocks, parting);
    if (count(above) > count(test.opening)) {
        test.level = parting;
        test.opening = std::move(above);
    }
    if (count(test.opening) == 0) return {};
    test.islands = fill_islands(test.opening);
    const Vec3d block = design.space.block_mm;
    test.ring = spread(spread(test.opening, cells_for(least_ring_mm, block.y), true),
                       cells_for(least_ring_mm, block.z), false);
    for (std::size_t column = 0; column < test.ring.size(); ++column)
        if (test.opening[column] || !design.available[column].contains(test.level)) test.ring[column] = 0;
    for_each_piece(test.ring, [&](const std::vector<Place>&) { ++test.pieces; });
    return test;
}

std::vector<LayerTest> fit_tests(const FoamDesign& design) {
    std::vector<LayerTest> tests;
    for (int layer = 1; layer <= design.foams.layers(); ++layer)
        if (auto test = fit_test(design, kLeastRing, layer)) tests.push_back({layer, std::move(*test)});
    return tests;
}

std::string fit_test_stem(const FoamDesign& design, int layer) {
    return design.foams.layers() == 1 ? "fit-test" : "fit-test-" + std::to_string(layer);
}

}  // namespace snug
