#include "snug/fabricate/relief.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace snug {
namespace {

// A drawing about 1000 px wide cannot show more columns than this along one axis.
constexpr int kMostCells = 120;

int blocks_per_cell(int blocks) {
    return (blocks + kMostCells - 1) / kMostCells;
}
int cells(int blocks, int per_cell) {
    return (blocks + per_cell - 1) / per_cell;
}

/// The fewest blocks kept in one cell's columns: where columns are drawn together, a narrow cavity stays a
/// cavity and the drawing never shows foam in the object's place.
int fewest_kept(const Grid<std::uint16_t>& kept, int j0, int k0, int per_cell) {
    int fewest = std::numeric_limits<int>::max();
    for (int j = j0; j < std::min(j0 + per_cell, kept.ny()); ++j)
        for (int k = k0; k < std::min(k0 + per_cell, kept.nz()); ++k)
            fewest = std::min<int>(fewest, kept(j, k));
    return fewest;
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
    /// Of the cell nearer to the viewer.
    int layers_before(int row, int column) const {
        return row + 1 < relief_.layers.ny() ? relief_.layers(row + 1, column) : 0;
    }

    /// The run of equal height that begins here: its top, then the walls before it. Returns where it ends.
    int collect_run(int row, int begin) {
        const int layers = relief_.layers(row, begin);
        int end = begin + 1;
        while (end < relief_.layers.nz() && relief_.layers(row, end) == layers) ++end;
        if (layers == 0) return end;
        const double left = relief_.right_faces[begin], right = relief_.right_faces[end];
        const double back = relief_.front_faces[row], front = relief_.front_faces[row + 1];
        const double top = relief_.height(row, begin);
        faces_.push_back(
            {FaceSide::top, {left, back, top}, {right - left, 0, 0}, {0, front - back, 0}, end - begin, 1});
        collect_front_walls(row, begin, end, layers);
        if (end < relief_.layers.nz() && relief_.layers(row, end) < layers) {
            const int exposed = layers - relief_.layers(row, end);
            faces_.push_back({FaceSide::right,
                              {right, back, top},
                              {0, front - back, 0},
                              {0, 0, -exposed * relief_.layer_mm},
                              1,
                              exposed});
        }
        return end;
    }

    /// Nothing stands before the outermost wall, so that its rows of equal height can be one face.
    int collect_outer_right_wall(int begin) {
        const int column = relief_.layers.nz() - 1;
        const int layers = relief_.layers(begin, column);
        int end = begin + 1;
        while (end < relief_.layers.ny() && relief_.layers(end, column) == layers) ++end;
        const double back = relief_.front_faces[begin], front = relief_.front_faces[end];
        if (layers > 0)
            faces_.push_back({FaceSide::right,
                              {relief_.right_faces.back(), back, relief_.height(begin, column)},
                              {0, front - back, 0},
                              {0, 0, -layers * relief_.layer_mm},
                              end - begin,
                              layers});
        return end;
    }

    void collect_front_walls(int row, int begin, int end, int layers) {
        while (begin < end) {
            const int before = layers_before(row, begin);
            int stop = begin + 1;
            while (stop < end && layers_before(row, stop) == before) ++stop;
            if (before < layers) {
                const double left = relief_.right_faces[begin], right = relief_.right_faces[stop];
                const int exposed = layers - before;
                faces_.push_back({FaceSide::front,
                                  {left, relief_.front_faces[row + 1], relief_.height(row, begin)},
                                  {right - left, 0, 0},
                                  {0, 0, -exposed * relief_.layer_mm},
                                  stop - begin,
                                  exposed});
            }
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

Relief relief(const FoamPair& foams, const DesignSpace& space, const OpenedPair& pair, Half half) {
    const bool lower = half == Half::lower;
    const Grid<std::uint16_t>& kept = lower ? foams.lower : foams.upper;
    const int ny = kept.ny(), nz = kept.nz();
    const int per_cell = std::max(blocks_per_cell(ny), blocks_per_cell(nz));
    const int rows = cells(ny, per_cell), columns = cells(nz, per_cell);
    const auto in_scene = [&](Vec3d design) { return lower ? pair.lower(design) : pair.lid(design); };
    const auto face = [&](int axis, int cell) {
        return space.face(axis, std::min(cell * per_cell, axis == 1 ? ny : nz));
    };

    Relief relief{{rows, columns}, {}, {}, 0, space.block_mm.x, per_cell};
    relief.bottom = in_scene({space.face(0, lower ? 0 : space.blocks.x), 0, 0}).z;
    // The lid's row that is farthest from its BACK edge lies farthest from the viewer.
    for (int row = 0; row <= rows; ++row)
        relief.front_faces.push_back(in_scene({0, face(1, lower ? row : rows - row), 0}).y);
    for (int column = 0; column <= columns; ++column) relief.right_faces.push_back(face(2, column));
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            relief.layers(row, column) =
                fewest_kept(kept, (lower ? row : rows - 1 - row) * per_cell, column * per_cell, per_cell);
    return relief;
}

// Back to front is row by row and, within a row, left to right: a sight line leaves a cell only towards the
// viewer, to the right and upward. A cell's walls stand on its far sides, so they follow its top.
std::vector<Face> visible_faces(const Relief& relief) {
    return FaceCollector(relief).collect();
}

}  // namespace snug
