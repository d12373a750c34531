#include "snug/picture/foam_drawing.h"

#include <algorithm>
#include <vector>

#include "snug/drawing/svg.h"
#include "snug/picture/foam_tones.h"

namespace snug {
namespace {

constexpr double kLeastBlock = 5;   // px, to draw a block's edges
constexpr double kClearBlock = 16;  // px, from which on edges are drawn at full strength
constexpr double kEdgeShare = 0.2;  // of black in an edge's colour
constexpr double kFaceSeam = 0.9;   // px: lines, and what closes the seams between faces

class FoamPainter {
  public:
    FoamPainter(Canvas& canvas, const Page& page, const Relief& relief, Color foam)
        : canvas_(canvas), page_(page), tones_(relief, foam) {
        const bool whole_blocks = relief.blocks_per_cell == 1;
        const auto strength = [&](double px) {
            return whole_blocks && px >= kLeastBlock
                       ? kEdgeShare *
                             std::min(1.0, 0.35 + 0.65 * (px - kLeastBlock) / (kClearBlock - kLeastBlock))
                       : 0.0;
        };
        const double column = relief.right_faces[1] - relief.right_faces[0];
        const double row = relief.front_faces[1] - relief.front_faces[0];
        column_edge_ = strength(size_of({column, 0, 0}));
        row_edge_ = strength(size_of({0, row, 0}));
        layer_edge_ = strength(size_of({0, 0, relief.layer_mm}));
    }

    void paint(const Face& face) {
        const Color color = tones_.of(face);
        std::vector<Vec2d> corners{page_.at(face.origin), page_.at(face.origin + face.across),
                                   page_.at(face.origin + face.across + face.along),
                                   page_.at(face.origin + face.along)};
        // All faces run the same way round, so that overlapping ones of one path cannot cancel.
        if (face.side == FaceSide::right) std::reverse(corners.begin(), corners.end());
        canvas_.facet(color, corners, kFaceSeam);
        const double across_edge = face.side == FaceSide::right ? row_edge_ : column_edge_;
        const double along_edge = face.side == FaceSide::top ? row_edge_ : layer_edge_;
        edges(color, across_edge, face.origin, face.across, face.cells_across, face.along);
        edges(color, along_edge, face.origin, face.along, face.cells_along, face.across);
    }

  private:
    double size_of(Vec3d mm) const { return length(project(mm).at) * page_.scale; }

    /// The `count` lines where blocks begin along `way`. The last block's end belongs to the neighbour, whose
    /// polygon would cover half of it.
    void edges(Color color, double strength, Vec3d origin, Vec3d way, int count, Vec3d line) {
        if (strength == 0) return;
        const Color edge = mixed(color, kBlack, strength);
        for (int i = 0; i < count; ++i) {
            const Vec3d from = origin + way * (static_cast<double>(i) / count);
            canvas_.facet_line(edge, page_.at(from), page_.at(from + line), kFaceSeam);
        }
    }

    Canvas& canvas_;
    const Page& page_;
    FoamTones tones_;
    double column_edge_ = 0, row_edge_ = 0, layer_edge_ = 0;
};

}  // namespace

void draw_foam(Canvas& canvas, const Page& page, const Relief& relief, std::span<const Face> faces,
               Color foam) {
    FoamPainter painter(canvas, page, relief, foam);
    for (const Face& face : faces) painter.paint(face);
}

}  // namespace snug
