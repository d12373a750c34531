#include "snug/fabricate/solid.h"

#include <algorithm>
#include <utility>

#include "snug/fabricate/corners.h"
#include "snug/fabricate/run_solid.h"
#include "snug/fabricate/triangulate.h"

namespace snug {
namespace {

using Heights = Grid<std::uint16_t>;

/// Where the column stands at the corner's line: `behind` at j = J, else at j = J - 1.
std::uint32_t vertex_of(const SolidCorner& corner, bool behind) {
    return corner.vertex + (corner.doubled && behind ? 1 : 0);
}

/// The faces that look up (the tops, one face a level) or down (the base). Rows lie along y, positions along
/// z.
class LevelFaces {
  public:
    LevelFaces(const Heights& heights, const SolidCorners& corners, bool base)
        : heights_(heights), corners_(corners), base_(base) {}

    void add_to(std::vector<Triangle>& triangles) {
        RowTriangulator triangulator(triangles);
        for (int J = 0; J <= heights_.ny(); ++J) {
            find_corners(J);
            find_runs(J);
            triangulator.step(J, line_corners_, runs_);
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
            line_corners_.push_back({K, vertex(line, J - 1, K - 1, false), vertex(line, J - 1, K, false),
                                     vertex(line, J, K - 1, true), vertex(line, J, K, true)});
        }
    }

    void find_runs(int j) {
        runs_.clear();
        if (j == heights_.ny()) return;
        for (int k = 0; k < heights_.nz(); ++k) {
            const int here = face(j, k);
            if (here == 0) continue;
            if (!runs_.empty() && runs_.back().end == k && runs_.back().face == here)
                ++runs_.back().end;
            else
                runs_.push_back({k, k + 1, here});
        }
    }

    const Heights& heights_;
    const SolidCorners& corners_;
    bool base_;
    std::vector<LineCorner> line_corners_;
    std::vector<FaceRun> runs_;
};

/// The upright faces in the planes between columns. Rows lie along the other horizontal axis, positions
/// along x.
class SideFaces {
  public:
    /// `along_y`: the planes that stand across y.
    SideFaces(const Heights& heights, const SolidCorners& corners, bool along_y)
        : heights_(heights), corners_(corners), along_y_(along_y) {}

    void add_to(std::vector<Triangle>& triangles) {
        RowTriangulator triangulator(triangles);
        const int planes = along_y_ ? heights_.ny() : heights_.nz();
        const int rows = along_y_ ? heights_.nz() : heights_.ny();
        for (int plane = 0; plane <= planes; ++plane) {
            Side previous;
            for (int line = 0; line <= rows; ++line) {
                const Side next = side(plane, line);
                find_corners(plane, line, previous, next);
                const FaceRun run{next.low, next.high, next.face};
                triangulator.step(line, line_corners_, {&run, run.face != 0 ? 1u : 0u});
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
            line_corners_.push_back({corner.level, before, before, after, after});
        }
    }

    const Heights& heights_;
    const SolidCorners& corners_;
    bool along_y_;
    std::vector<LineCorner> line_corners_;
};

std::vector<Vec3f> positions(const SolidCorners& corners, const DesignSpace& space, bool from_above) {
    std::vector<Vec3f> vertices;
    vertices.reserve(corners.vertex_count());
    for (int J = 0; J <= space.blocks.y; ++J) {
        for (int K = 0; K <= space.blocks.z; ++K) {
            for (const SolidCorner& corner : corners.on_line(J, K)) {
                const int level = from_above ? space.blocks.x - corner.level : corner.level;
                const Vec3d position{space.face(0, level), space.face(1, J), space.face(2, K)};
                vertices.insert(vertices.end(), corner.doubled ? 2 : 1, vec_cast<float>(position));
            }
        }
    }
    return vertices;
}

Solid solid(const Heights& heights, const DesignSpace& space, bool from_above) {
    const SolidCorners corners(heights);
    Solid result{positions(corners, space, from_above), {}};
    LevelFaces(heights, corners, true).add_to(result.triangles);
    LevelFaces(heights, corners, false).add_to(result.triangles);
    SideFaces(heights, corners, true).add_to(result.triangles);
    SideFaces(heights, corners, false).add_to(result.triangles);
    if (from_above)
        for (Triangle& t : result.triangles) std::swap(t[1], t[2]);
    return result;
}

/// Whether some column is kept but does not begin at its own side of the space.
bool is_shortened(const Heights& missing) {
    return std::any_of(missing.begin(), missing.end(), [](std::uint16_t blocks) { return blocks > 0; });
}

Solid shortened_solid(const Heights& heights, const Heights& missing, const DesignSpace& space,
                      bool from_above) {
    Grid<CutRun> runs(heights.ny(), heights.nz());
    for (std::size_t column = 0; column < runs.size(); ++column) {
        const int from = missing[column], to = heights[column], nx = space.blocks.x;
        runs[column] = {static_cast<std::int16_t>(from_above ? nx - to : from),
                        static_cast<std::int16_t>(from_above ? nx - from : to)};
    }
    return run_solid(runs, space);
}

}  // namespace

Solid lower_solid(const FoamPair& foams, const DesignSpace& space) {
    if (is_shortened(foams.lower_missing))
        return shortened_solid(foams.lower, foams.lower_missing, space, false);
    return solid(foams.lower, space, false);
}
Solid upper_solid(const FoamPair& foams, const DesignSpace& space) {
    if (is_shortened(foams.upper_missing))
        return shortened_solid(foams.upper, foams.upper_missing, space, true);
    return solid(foams.upper, space, true);
}

}  // namespace snug
