#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "snug/base/vec.h"

namespace snug {

constexpr std::uint32_t kNoVertex = 0xffffffff;

/// Cells [begin, end) of one row of a plane that belong to the same face. Cells of equal `face` that share a
/// side are one region. The triangles of a face above 0 turn from the direction of the rows towards the
/// direction of the positions, those of a face below 0 the other way round; 0 is no face.
struct FaceRun {
    int begin = 0;
    int end = 0;
    int face = 0;
};

/// A point on the line between two rows: for each of the four cells around it, the vertex that stands here
/// for that cell's face, or kNoVertex. Cells of one region that share a side have the same vertex.
struct LineCorner {
    int position = 0;
    std::uint32_t previous_left = kNoVertex;   ///< the cell of the previous row that ends here
    std::uint32_t previous_right = kNoVertex;  ///< the cell of the previous row that begins here
    std::uint32_t next_left = kNoVertex;
    std::uint32_t next_right = kNoVertex;
};

/// Triangulates the regions of a plane of cells, row by row, with no other vertices than those on their
/// outlines: holes, regions that touch themselves in a point and any number of vertices along a straight side
/// are fine, and no triangle is degenerate. A plane sweep after Hertel and Mehlhorn, Fast triangulation of
/// simple polygons (1983); time and memory follow the runs and corners, so faces of millions of cells are no
/// matter. Outlines that run in any other direction are for clip_ears().
class RowTriangulator {
  public:
    /// Triangles are appended to `triangles`, which must outlive this.
    explicit RowTriangulator(std::vector<Triangle>& triangles) : triangles_(triangles) {}

    /// Passes the line before the row `next`. Lines come in ascending order; the row before the first line
    /// and the row after the last one are empty, and then the next plane may begin. Runs are as long as they
    /// can be, in order. `corners` are in order as well, each position once, with a vertex wherever an
    /// outline turns.
    void step(int line, std::span<const LineCorner> corners, std::span<const FaceRun> next);

  private:
    using Id = std::uint32_t;

    struct Node {
        Id vertex;
        int row, position;
        Id left, right;
    };

    /// The border between what is triangulated and what is not yet, from the left to the right side of a run.
    /// Seen from the part to come it never turns inwards: every node but the ends has an angle of 180 degrees
    /// or more.
    struct Chain {
        Id first, last;
        Id latest;  ///< the newest node: nothing stands between it and the sweep
        int face;
    };

    struct ActiveRun {
        FaceRun cells;
        Id chain;
    };

    class Cursor;

    void pass(int line, const LineCorner& corner, Cursor& previous, Cursor& next);
    void start(ActiveRun& run, Node corner);
    void bend_left(Id chain, Node corner);
    void bend_right(Id chain, Node corner);
    void end(Id chain, Node corner);
    void merge(Id left, Id right, Node corner);
    Id split(Id chain, Node corner);

    bool cut_off(const Node& left, const Node& middle, const Node& right, int face);
    Id new_node(Node node);
    Id new_chain(Chain chain);

    std::vector<Triangle>& triangles_;
    std::vector<ActiveRun> previous_;
    std::vector<ActiveRun> next_;
    std::vector<Node> nodes_;
    std::vector<Chain> chains_;
    std::vector<Id> free_nodes_;
    std::vector<Id> free_chains_;
};

}  // namespace snug
