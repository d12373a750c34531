#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "snug/picture/isometric.h"

namespace snug {

/// The part of the drawing that an image covers, in square cells.
struct ImageFrame {
    Vec2d corner;     ///< upper left, in the drawing's mm
    double cell = 1;  ///< mm
    int width = 0;
    int height = 0;
};

/// For each cell the nearness of what is nearest to the viewer there, or nothing.
class DepthImage {
  public:
    explicit DepthImage(const ImageFrame& frame);

    /// Covers the cells whose centre lies in the triangle; with `outline` also every cell that its edges
    /// pass, so that slivers and triangles seen edge-on leave no holes. What lies outside the frame is left
    /// out. The image does not depend on the triangles' order.
    void draw(const Projected& a, const Projected& b, const Projected& c, bool outline);

    [[nodiscard]] const ImageFrame& frame() const { return frame_; }
    [[nodiscard]] bool covered(int column, int row) const { return nearness(column, row) > kNothing; }
    /// -infinity where nothing was drawn.
    [[nodiscard]] double nearness(int column, int row) const { return cells_[index(column, row)]; }

  private:
    static constexpr double kNothing = -std::numeric_limits<double>::infinity();

    [[nodiscard]] std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(frame_.width) +
               static_cast<std::size_t>(column);
    }
    void fill(const Projected& a, const Projected& b, const Projected& c);
    void line(const Projected& a, const Projected& b);
    [[nodiscard]] Projected in_cells(const Projected& p) const;

    ImageFrame frame_;
    std::vector<double> cells_;
};

}  // namespace snug
