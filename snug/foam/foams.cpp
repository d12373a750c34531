#include "snug/foam/foams.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "snug/space/available.h"

namespace snug {
namespace {

std::int16_t below_layer(CutRun cut, int parting) {
    return cut.none() ? static_cast<std::int16_t>(parting) : cut.first;
}
std::int16_t above_layer(CutRun cut, int parting) {
    return cut.none() ? static_cast<std::int16_t>(parting) : cut.end;
}

/// Of one column, all pieces.
void split_column(std::size_t column, std::span<const BlockMap> layers, Run exists, Foams& foams) {
    std::int16_t begin = exists.first;
    for (std::size_t piece = 0; piece <= layers.size(); ++piece) {
        if (piece > 0)
            begin = std::max(begin, above_layer(layers[piece - 1][column], foams.parting[piece - 1]));
        foams.pieces[piece][column].first = begin;
    }
    std::int16_t end = exists.end;
    for (std::size_t piece = layers.size() + 1; piece-- > 0;) {
        if (piece < layers.size())
            end = std::min(end, below_layer(layers[piece][column], foams.parting[piece]));
        Run& kept = foams.pieces[piece][column];
        kept.end = end;
        if (kept.none()) kept = {};
    }
}

int lowest_level(const Grid<Run>& kept, int nx) {
    int lowest = nx;
    for (const Run run : kept)
        if (!run.none()) lowest = std::min<int>(lowest, run.first);
    return lowest == nx ? 0 : lowest;
}

}  // namespace

std::vector<Piece> Foams::all() const {
    std::vector<Piece> all;
    for (std::size_t i = 0; i < pieces.size(); ++i) all.push_back(at(static_cast<int>(i)));
    return all;
}

Foams split(std::span<const BlockMap> layers, std::vector<int> parting, const Grid<Run>& available) {
    assert(layers.size() == parting.size() && std::is_sorted(parting.begin(), parting.end()));
    Foams foams;
    foams.pieces.assign(layers.size() + 1, Grid<Run>(available.ny(), available.nz()));
    foams.parting = std::move(parting);
    for (std::size_t column = 0; column < available.size(); ++column)
        split_column(column, layers, available[column], foams);
    return foams;
}

Foams split(const BlockMap& blocks, int parting_level, const Grid<Run>& available) {
    return split({&blocks, 1}, {parting_level}, available);
}

Foams split(const BlockMap& blocks, const DesignSpace& space, int parting_level) {
    return split(blocks, parting_level, all_blocks(space.blocks));
}

Foams without_lid(Foams foams) {
    foams.pieces.pop_back();
    return foams;
}

Vec3d outer_size(const Foams& foams, const DesignSpace& space) {
    Vec3d size = space.size();
    if (foams.open()) size.x = foams.parting.back() * space.block_mm.x;
    return size;
}

Grid<Run> kept_runs(const Foams& foams, Half half, int nx) {
    if (half == Half::lid && foams.open()) return {foams.pieces.front().ny(), foams.pieces.front().nz()};
    return seen_piece(foams, half == Half::lower ? foams.at(0) : foams.at(foams.layers()), half, nx).kept;
}

SeenPiece seen_piece(const Foams& foams, Piece piece, Half from, int nx) {
    SeenPiece seen{foams.piece(piece), 0};
    if (from == Half::lid)
        for (Run& run : seen.kept)
            if (!run.none()) run = from_other_end(run, nx);
    if (!piece.middle()) return seen;
    seen.under = lowest_level(seen.kept, nx);
    const auto under = static_cast<std::int16_t>(seen.under);
    for (Run& run : seen.kept)
        if (!run.none())
            run = {static_cast<std::int16_t>(run.first - under), static_cast<std::int16_t>(run.end - under)};
    return seen;
}

SeenPiece seen_piece(const Foams& foams, Piece piece, int nx) {
    return seen_piece(foams, piece, piece.half(), nx);
}

}  // namespace snug
