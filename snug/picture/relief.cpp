#include "snug/picture/relief.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace snug {
namespace {

// A drawing about 1000 px wide cannot show more columns than this along one axis.
constexpr int kMostReliefCells = 120;

int blocks_per_cell(int blocks) {
    return (blocks + kMostReliefCells - 1) / kMostReliefCells;
}
int cells(int blocks, int per_cell) {
    return (blocks + per_cell - 1) / per_cell;
}

/// The blocks that all of one cell's columns keep: where columns are drawn together, a narrow cavity stays a
/// cavity and the drawing never shows foam in the object's place.
Run kept_by_all(const Grid<Run>& kept, int j0, int k0, int per_cell) {
    Run all = kept(j0, k0);
    for (int j = j0; j < std::min(j0 + per_cell, kept.ny()); ++j)
        for (int k = k0; k < std::min(k0 + per_cell, kept.nz()); ++k) all = all.common(kept(j, k));
    return all.none() ? Run{} : all;
}

/// Goes through a relief and collects its faces.
class FaceCollector {
  public:
    explicit FaceCollector(const Relief& relief) : relief_(relief) {}

    std::vector<Face> collect() {
        for (int row = 0; row < relief_.layers.ny(); ++row)
            for (int column = 0; column < relief_.layers.nz();) column = collect_run(row, column);
        for (int row = 0; row < relief_.layers.ny();) row = collect_outer_right_wall(row);
        return std::move(faces_);
    }

  private:
    /// The levels of a cell that are foam.
    Run foam(int row, int column) const {
        if (!relief_.layers.contains(row, column)) return {};
        return {static_cast<std::int16_t>(relief_.missing(row, column)),
                static_cast<std::int16_t>(relief_.layers(row, column))};
    }

    /// What is seen of a wall of these levels behind a neighbour: above it, and below it where a case
    /// shortens it more. `top`: where the wall stands, at its upper left.
    void collect_wall(FaceSide side, Vec3d place, Vec3d across, int cells_across, Run wall, Run before) {
        const auto add = [&](int from, int to) {
            if (from >= to) return;
            place.z = relief_.bottom + to * relief_.layer_mm;
            faces_.push_back(
                {side, place, across, {0, 0, -(to - from) * relief_.layer_mm}, cells_across, to - from});
        };
        if (before.none()) return add(wall.first, wall.end);
        add(wall.first, std::min(wall.end, before.first));
        add(std::max(wall.first, before.end), wall.end);
    }

    /// The run of equal height that begins here: its top, then the walls before it. Returns where it ends.
    int collect_run(int row, int begin) {
        const int layers = relief_.layers(row, begin);
        int end = begin + 1;
        while (end < relief_.layers.nz() && relief_.layers(row, end) == layers) ++end;
        if (layers == 0) return end;
        // A leaning case may shorten columns of the run from below, each more than the one before; the walls
        // there stand under the run and behind its front.
        for (int column = begin; column + 1 < end; ++column)
            if (foam(row, column) != foam(row, column + 1)) collect_right_wall(row, column);
        const double left = relief_.right_faces[begin], right = relief_.right_faces[end];
        const double back = relief_.front_faces[row], front = relief_.front_faces[row + 1];
        const double top = relief_.height(row, begin);
        faces_.push_back(
            {FaceSide::top, {left, back, top}, {right - left, 0, 0}, {0, front - back, 0}, end - begin, 1});
        collect_front_walls(row, begin, end);
        if (end < relief_.layers.nz()) collect_right_wall(row, end - 1);
        return end;
    }

    void collect_right_wall(int row, int column) {
        const double back = relief_.front_faces[row], front = relief_.front_faces[row + 1];
        collect_wall(FaceSide::right, {relief_.right_faces[column + 1], back, 0}, {0, front - back, 0}, 1,
                     foam(row, column), foam(row, column + 1));
    }

    /// Nothing stands before the outermost wall, so that its rows of equal height can be one face.
    int collect_outer_right_wall(int begin) {
        const int column = relief_.layers.nz() - 1;
        const Run wall = foam(begin, column);
        int end = begin + 1;
        while (end < relief_.layers.ny() && foam(end, column) == wall) ++end;
        const double back = relief_.front_faces[begin], front = relief_.front_faces[end];
        collect_wall(FaceSide::right, {relief_.right_faces.back(), back, 0}, {0, front - back, 0},
                     end - begin, wall, {});
        return end;
    }

    void collect_front_walls(int row, int begin, int end) {
        while (begin < end) {
            const Run wall = foam(row, begin), before = foam(row + 1, begin);
            int stop = begin + 1;
            while (stop < end && foam(row, stop) == wall && foam(row + 1, stop) == before) ++stop;
            const double left = relief_.right_faces[begin], right = relief_.right_faces[stop];
            collect_wall(FaceSide::front, {left, relief_.front_faces[row + 1], 0}, {right - left, 0, 0},
                         stop - begin, wall, before);
            begin = stop;
        }
    }

    const Relief& relief_;
    std::vector<Face> faces_;
};

}  // namespace

int Relief::fewest_layers() const {
    return *std::min_element(layers.begin(), layers.end());
}

Relief relief(const Foams& foams, const DesignSpace& space, const OpenedPair& pair, Half half) {
    return relief(foams, half, space, pair, half);
}

Relief relief(const Foams& foams, Piece piece, const DesignSpace& space, const OpenedPair& pair, Half half) {
    const bool lower = half == Half::lower;
    const auto [kept, under] = seen_piece(foams, piece, half, space.blocks.x);
    const int ny = kept.ny(), nz = kept.nz();
    const int per_cell = std::max(blocks_per_cell(ny), blocks_per_cell(nz));
    const int rows = cells(ny, per_cell), columns = cells(nz, per_cell);
    const auto in_scene = [&](Vec3d design) { return lower ? pair.lower(design) : pair.lid(design); };
    const auto face = [&](int axis, int cell) {
        return space.face(axis, std::min(cell * per_cell, axis == 1 ? ny : nz));
    };

    Relief relief{{rows, columns}, {}, {}, 0, space.block_mm.x, per_cell, {rows, columns}};
    relief.bottom = in_scene({space.face(0, lower ? under : space.blocks.x - under), 0, 0}).z;
    // The lid's row that is farthest from its BACK edge lies farthest from the viewer.
    for (int row = 0; row <= rows; ++row)
        relief.front_faces.push_back(in_scene({0, face(1, lower ? row : rows - row), 0}).y);
    for (int column = 0; column <= columns; ++column) relief.right_faces.push_back(face(2, column));
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const Run cell =
                kept_by_all(kept, (lower ? row : rows - 1 - row) * per_cell, column * per_cell, per_cell);
            relief.layers(row, column) = cell.end;
            relief.missing(row, column) = cell.first;
        }
    return relief;
}

// Back to front is row by row and, within a row, left to right: a sight line leaves a cell only towards the
// viewer, to the right and upward. A cell's walls stand on its far sides, so they follow its top.
std::vector<Face> visible_faces(const Relief& relief) {
    return FaceCollector(relief).collect();
}

PieceScene piece_scene(const Foams& foams, Piece piece, const DesignSpace& space, const OpenedPair& pair,
                       Half half) {
    PieceScene scene{piece, relief(foams, piece, space, pair, half), {}};
    scene.faces = visible_faces(scene.relief);
    return scene;
}

}  // namespace snug
