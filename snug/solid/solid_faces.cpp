#include "snug/solid/solid_faces.h"

#include <algorithm>

namespace snug {
namespace {

using Heights = Grid<std::uint16_t>;

/// Where the column stands at the corner's line: `behind` at j = J, else at j = J - 1.
std::uint32_t vertex_of(const SolidCorner& corner, bool behind) {
    return corner.vertex + (corner.doubled && behind ? 1 : 0);
}

/// The runs less the openings that the strip after `line` crosses.
std::vector<FaceRun> open_runs(std::span<const FaceRun> runs, std::span<const FaceOpening> openings,
                               int line) {
    std::vector<FaceRun> open(runs.begin(), runs.end());
    for (const FaceOpening& opening : openings) {
        if (line < opening.row_begin || line >= opening.row_end) continue;
        for (std::size_t i = 0; i < open.size(); ++i) {
            const FaceRun whole = open[i];
            if (opening.position_begin <= whole.begin || opening.position_end >= whole.end) continue;
            open[i].end = opening.position_begin;
            open.insert(open.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                        {opening.position_end, whole.end, whole.face});
            break;
        }
    }
    return open;
}

void add_opening_corners(std::span<const FaceOpening> openings, int line, std::vector<LineCorner>& corners) {
    for (const FaceOpening& opening : openings) {
        const std::uint32_t first = opening.first_vertex;
        if (line == opening.row_begin) {
            corners.push_back({opening.position_begin, first, first, first, kNoVertex});
            corners.push_back({opening.position_end, first + 1, first + 1, kNoVertex, first + 1});
        } else if (line == opening.row_end) {
            corners.push_back({opening.position_begin, first + 2, kNoVertex, first + 2, first + 2});
            corners.push_back({opening.position_end, kNoVertex, first + 3, first + 3, first + 3});
        }
    }
    std::sort(corners.begin(), corners.end(),
              [](const LineCorner& a, const LineCorner& b) { return a.position < b.position; });
}

/// Passes the block line before a row and every line within the row at which an opening begins or ends.
void step_row(RowTriangulator& triangulator, int row, std::vector<LineCorner>& corners,
              std::span<const FaceRun> runs, std::span<const FaceOpening> openings) {
    const int first = row * kBlockSteps;
    if (openings.empty()) {
        triangulator.step(first, corners, runs);
        return;
    }
    std::vector<int> lines{first};
    for (const FaceOpening& opening : openings)
        for (const int line : {opening.row_begin, opening.row_end})
            if (line > first && line < first + kBlockSteps) lines.push_back(line);
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    for (const int line : lines) {
        add_opening_corners(openings, line, corners);
        triangulator.step(line, corners, open_runs(runs, openings, line));
        corners.clear();
    }
}

/// The faces that look up (the tops, one face a level) or down (the base). Rows lie along y, positions along
/// z.
class LevelFaces {
  public:
    LevelFaces(const Heights& heights, const SolidCorners& corners, std::span<const FaceOpening> openings,
               bool base)
        : heights_(heights), corners_(corners), base_(base) {
        for (const FaceOpening& opening : openings)
            if (opening.axis == 0 && (opening.plane == 0) == base) openings_.push_back(opening);
    }

    void add_to(std::vector<Triangle>& triangles) {
        RowTriangulator triangulator(triangles);
        for (int J = 0; J <= heights_.ny(); ++J) {
            find_corners(J);
            find_runs(J);
            step_row(triangulator, J, line_corners_, runs_, openings_);
        }
    }

  private:
    [[nodiscard]] int face(int j, int k) const {
        const int height = height_at(heights_, j, k);
        return base_ && height > 0 ? -1 : height;
    }

    [[nodiscard]] std::uint32_t vertex(std::span<const SolidCorner> line, int j, int k, bool behind) const {
        const int height = height_at(heights_, j, k);
        if (height == 0) return kNoVertex;
        for (const SolidCorner& corner : line)
            if (corner.level == (base_ ? 0 : height)) return vertex_of(corner, behind);
        return kNoVertex;
    }

    void find_corners(int J) {
        line_corners_.clear();
        for (int K = 0; K <= heights_.nz(); ++K) {
            const auto line = corners_.on_line(J, K);
            if (line.empty()) continue;
            line_corners_.push_back({K * kBlockSteps, vertex(line, J - 1, K - 1, false),
                                     vertex(line, J - 1, K, false), vertex(line, J, K - 1, true),
                                     vertex(line, J, K, true)});
        }
    }

    void find_runs(int j) {
        runs_.clear();
        if (j == heights_.ny()) return;
        for (int k = 0; k < heights_.nz(); ++k) {
            const int here = face(j, k);
            if (here == 0) continue;
            const int begin = k * kBlockSteps, end = begin + kBlockSteps;
            if (!runs_.empty() && runs_.back().end == begin && runs_.back().face == here)
                runs_.back().end = end;
            else
                runs_.push_back({begin, end, here});
        }
    }

    const Heights& heights_;
    const SolidCorners& corners_;
    std::vector<FaceOpening> openings_;
    bool base_;
    std::vector<LineCorner> line_corners_;
    std::vector<FaceRun> runs_;
};

/// The upright faces in the planes between columns. Rows lie along the other horizontal axis, positions
/// along x.
class SideFaces {
  public:
    /// `along_y`: the planes that stand across y.
    SideFaces(const Heights& heights, const SolidCorners& corners, std::span<const FaceOpening> openings,
              bool along_y)
        : heights_(heights), corners_(corners), along_y_(along_y) {
        for (const FaceOpening& opening : openings)
            if (opening.axis == (along_y ? 1 : 2)) openings_.push_back(opening);
    }

    void add_to(std::vector<Triangle>& triangles) {
        RowTriangulator triangulator(triangles);
        const int planes = along_y_ ? heights_.ny() : heights_.nz();
        const int rows = along_y_ ? heights_.nz() : heights_.ny();
        for (int plane = 0; plane <= planes; ++plane) {
            std::vector<FaceOpening> here;
            for (const FaceOpening& opening : openings_)
                if (opening.plane == plane) here.push_back(opening);
            Side previous;
            for (int line = 0; line <= rows; ++line) {
                const Side next = side(plane, line);
                find_corners(plane, line, previous, next);
                const FaceRun run{next.low * kBlockSteps, next.high * kBlockSteps, next.face};
                step_row(triangulator, line, line_corners_, {&run, run.face != 0 ? 1u : 0u}, here);
                previous = next;
            }
        }
    }

  private:
    /// What shows between the two columns of a row on both sides of the plane: the taller one from `low` to
    /// `high`.
    struct Side {
        int low = 0, high = 0;
        int face = 0;
        int taller_j = 0;
    };

    [[nodiscard]] Side side(int plane, int row) const {
        const int first =
            along_y_ ? height_at(heights_, plane - 1, row) : height_at(heights_, row, plane - 1);
        const int second = along_y_ ? height_at(heights_, plane, row) : height_at(heights_, row, plane);
        if (first == second) return {};
        // From z to x is a turn about +y, from y to x one about -z.
        const bool turned = (first > second) == along_y_;
        const int taller_j = !along_y_ ? row : first > second ? plane - 1 : plane;
        return {std::min(first, second), std::max(first, second), turned ? 1 : -1, taller_j};
    }

    void find_corners(int plane, int line, const Side& previous, const Side& next) {
        line_corners_.clear();
        if (previous.face == 0 && next.face == 0) return;
        const int J = along_y_ ? plane : line;
        const int K = along_y_ ? line : plane;
        for (const SolidCorner& corner : corners_.on_line(J, K)) {
            const std::uint32_t before = vertex_of(corner, previous.taller_j == J);
            const std::uint32_t after = vertex_of(corner, next.taller_j == J);
            line_corners_.push_back({corner.level * kBlockSteps, before, before, after, after});
        }
    }

    const Heights& heights_;
    const SolidCorners& corners_;
    std::vector<FaceOpening> openings_;
    bool along_y_;
    std::vector<LineCorner> line_corners_;
};

}  // namespace

void add_faces(const Heights& heights, const SolidCorners& corners, std::span<const FaceOpening> openings,
               std::vector<Triangle>& triangles) {
    LevelFaces(heights, corners, openings, true).add_to(triangles);
    LevelFaces(heights, corners, openings, false).add_to(triangles);
    SideFaces(heights, corners, openings, true).add_to(triangles);
    SideFaces(heights, corners, openings, false).add_to(triangles);
}

}  // namespace snug
