#include "snug/solid/solid_faces.h"

#include <algorithm>
#include <array>

namespace snug {
namespace {

/// The faces that look up (the tops) or down (the bottoms), those at one level being one face. Rows lie along
/// y, positions along z.
class LevelFaces {
  public:
    LevelFaces(const Grid<Run>& columns, const SolidCorners& corners, std::span<const FaceOpening> openings,
               Vec3i block_steps, bool bottoms)
        : columns_(columns), corners_(corners), block_steps_(block_steps), bottoms_(bottoms) {
        for (const FaceOpening& opening : openings)
            if (opening.axis == 0 && (opening.plane == 0) == bottoms) openings_.push_back(opening);
    }

    void add_to(std::vector<Triangle>& triangles) {
        RowTriangulator triangulator(triangles);
        for (int J = 0; J <= columns_.ny(); ++J) {
            find_corners(J);
            find_runs(J);
            step_row(triangulator, J * block_steps_.y, block_steps_.y, line_corners_, runs_, openings_);
        }
    }

  private:
    /// Of the cell of column (j, k) at line (J, K).
    [[nodiscard]] std::uint32_t vertex(std::span<const SolidCorner> line, int J, int K, int j, int k) const {
        const Run column = run_at(columns_, j, k);
        if (column.none()) return kNoVertex;
        const int octant = (j == J ? kOctantBit[1] : 0) | (k == K ? kOctantBit[2] : 0);
        for (const SolidCorner& corner : line)
            if (corner.level == (bottoms_ ? column.first : column.end))
                return corner.vertex_at(octant_face(octant, 0));
        return kNoVertex;
    }

    void find_corners(int J) {
        line_corners_.clear();
        for (int K = 0; K <= columns_.nz(); ++K) {
            const auto line = corners_.on_line(J, K);
            if (line.empty()) continue;
            line_corners_.push_back({K * block_steps_.z, vertex(line, J, K, J - 1, K - 1),
                                     vertex(line, J, K, J - 1, K), vertex(line, J, K, J, K - 1),
                                     vertex(line, J, K, J, K)});
        }
    }

    void find_runs(int j) {
        runs_.clear();
        if (j == columns_.ny()) return;
        for (int k = 0; k < columns_.nz(); ++k) {
            const Run column = columns_(j, k);
            if (column.none()) continue;
            const int face = bottoms_ ? -1 - column.first : column.end;
            const int begin = k * block_steps_.z, end = begin + block_steps_.z;
            if (!runs_.empty() && runs_.back().end == begin && runs_.back().face == face)
                runs_.back().end = end;
            else
                runs_.push_back({begin, end, face});
        }
    }

    const Grid<Run>& columns_;
    const SolidCorners& corners_;
    Vec3i block_steps_;
    std::vector<FaceOpening> openings_;
    bool bottoms_;
    std::vector<LineCorner> line_corners_;
    std::vector<FaceRun> runs_;
};

/// The upright faces in the planes between columns. Rows lie along the other horizontal axis, positions
/// along x.
class SideFaces {
  public:
    /// `axis`: the planes stand across y (1) or z (2).
    SideFaces(const Grid<Run>& columns, const SolidCorners& corners, std::span<const FaceOpening> openings,
              Vec3i block_steps, int axis)
        : columns_(columns), corners_(corners), block_steps_(block_steps), axis_(axis) {
        for (const FaceOpening& opening : openings)
            if (opening.axis == axis) openings_.push_back(opening);
    }

    void add_to(std::vector<Triangle>& triangles) {
        RowTriangulator triangulator(triangles);
        const int planes = along_y() ? columns_.ny() : columns_.nz();
        const int rows = along_y() ? columns_.nz() : columns_.ny();
        const int row_steps = along_y() ? block_steps_.z : block_steps_.y;
        for (int plane = 0; plane <= planes; ++plane) {
            std::vector<FaceOpening> here;
            for (const FaceOpening& opening : openings_)
                if (opening.plane == plane) here.push_back(opening);
            bool shown = false;
            for (int line = 0; line <= rows; ++line) {
                const bool shown_before = shown;
                find_runs(plane, line);
                shown = !runs_.empty();
                if (!shown && !shown_before) continue;
                find_corners(plane, line);
                step_row(triangulator, line * row_steps, row_steps, line_corners_, runs_, here);
            }
        }
    }

  private:
    [[nodiscard]] bool along_y() const { return axis_ == 1; }

    /// What shows between the two columns of a row on both sides of the plane: where one of them only has
    /// blocks, at most two intervals.
    void find_runs(int plane, int row) {
        runs_.clear();
        const Run before = along_y() ? run_at(columns_, plane - 1, row) : run_at(columns_, row, plane - 1);
        const Run after = along_y() ? run_at(columns_, plane, row) : run_at(columns_, row, plane);
        if (before == after) return;
        if (before.meets(after)) {
            add_run({std::min(before.first, after.first), std::max(before.first, after.first)},
                    before.first < after.first);
            add_run({std::min(before.end, after.end), std::max(before.end, after.end)},
                    before.end > after.end);
        } else if (before.first < after.first) {
            add_run(before, true);
            add_run(after, false);
        } else {
            add_run(after, false);
            add_run(before, true);
        }
    }

    /// `before`: of the column before the plane.
    void add_run(Run blocks, bool before) {
        if (blocks.none()) return;
        // From z to x is a turn about +y, from y to x one about -z.
        runs_.push_back(
            {blocks.first * block_steps_.x, blocks.end * block_steps_.x, before == along_y() ? 1 : -1});
    }

    void find_corners(int plane, int line) {
        line_corners_.clear();
        const int J = along_y() ? plane : line;
        const int K = along_y() ? line : plane;
        const int next = kOctantBit[along_y() ? 2 : 1], above = kOctantBit[0];
        for (const SolidCorner& corner : corners_.on_line(J, K)) {
            const auto vertex = [&](int octant) { return corner.vertex_at(octant_face(octant, axis_)); };
            line_corners_.push_back({corner.level * block_steps_.x, vertex(0), vertex(above), vertex(next),
                                     vertex(next | above)});
        }
    }

    const Grid<Run>& columns_;
    const SolidCorners& corners_;
    Vec3i block_steps_;
    std::vector<FaceOpening> openings_;
    int axis_;
    std::vector<LineCorner> line_corners_;
    std::vector<FaceRun> runs_;
};

}  // namespace

void add_faces(const Grid<Run>& runs, const SolidCorners& corners, std::span<const FaceOpening> openings,
               Vec3i block_steps, std::vector<Triangle>& triangles) {
    LevelFaces(runs, corners, openings, block_steps, true).add_to(triangles);
    LevelFaces(runs, corners, openings, block_steps, false).add_to(triangles);
    SideFaces(runs, corners, openings, block_steps, 1).add_to(triangles);
    SideFaces(runs, corners, openings, block_steps, 2).add_to(triangles);
}

void add_faces(const Grid<Run>& runs, const SolidCorners& corners, std::vector<Triangle>& triangles) {
    add_faces(runs, corners, {}, {1, 1, 1}, triangles);
}

}  // namespace snug
