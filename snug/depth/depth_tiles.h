#pragma once

#include <array>
#include <limits>
#include <vector>

#include "snug/base/vec.h"
#include "snug/depth/cells.h"
#include "snug/depth/depth_map.h"

namespace snug {

/// A placed triangle as squares of columns see it: what x it has over a rectangle in y and z.
class SpreadTriangle {
  public:
    struct Rectangle {
        double y_min, y_max, z_min, z_max;
        [[nodiscard]] std::array<std::array<double, 2>, 4> corners() const {
            return {{{y_min, z_min}, {y_min, z_max}, {y_max, z_min}, {y_max, z_max}}};
        }
    };

    explicit SpreadTriangle(const std::array<Vec3d, 3>& corners);

    /// Whether it may reach the rectangle, and whether it surely spans all of it.
    [[nodiscard]] bool may_meet(const Rectangle& r) const;
    [[nodiscard]] bool spans(const Rectangle& r) const;
    /// Whether `x_at` and the range below are of use: steep triangles are known by their own extremes alone.
    [[nodiscard]] bool has_plane() const { return has_plane_; }
    /// x of its plane; exact up to `slack`, as are the crossings that a depth map is filled with.
    [[nodiscard]] double x_at(double y, double z) const { return x0_ + slope_y_ * y + slope_z_ * z; }
    [[nodiscard]] double slack() const { return slack_; }
    /// All x that it may have over the rectangle, slack included.
    [[nodiscard]] DepthRange over(const Rectangle& r) const;

  private:
    struct Edge {
        double normal_y, normal_z;
        double least, most;  ///< of the triangle's corners along the normal
        double margin;
    };

    std::array<Edge, 3> edges_;
    DepthRange own_;
    bool has_plane_ = false;
    double x0_ = 0, slope_y_ = 0, slope_z_ = 0;
    double slack_;
};

/// What is surely known of squares of columns in a depth map, so that a large triangle is looked at only
/// where it may change something. Depth maps only ever grow, so that what was known stays true.
class DepthTiles {
  public:
    static constexpr int kSide = 32;  ///< columns of a tile along y and z, at most
    /// Whether a block of so many columns is worth the look at its tiles.
    [[nodiscard]] static constexpr bool pay(int rows, int columns) {
        return static_cast<long long>(rows) * columns > kSide * kSide;
    }

    DepthTiles() = default;
    DepthTiles(int rows, int columns);
    [[nodiscard]] bool empty() const { return tiles_.empty(); }

    /// Whether the triangle changes nothing in the tile, whose columns see the rectangle.
    [[nodiscard]] bool hides(int tile_j, int tile_k, const SpreadTriangle& triangle,
                             const SpreadTriangle::Rectangle& seen, const DepthMap& depths);
    /// After the triangle was added to the tile.
    void added(int tile_j, int tile_k, const SpreadTriangle& triangle, const SpreadTriangle::Rectangle& seen);

  private:
    /// A plane that the depth map has passed everywhere in a tile, by its x above the rectangle's corners.
    using Plane = std::array<double, 4>;
    struct Tile {
        double least_highest = -std::numeric_limits<double>::infinity();
        double most_lowest = std::numeric_limits<double>::infinity();
        bool spanned = false;
        int next_look = 0, idle = 0;  ///< triangles until its columns are looked at again
        Plane above{}, below{};
    };

    static void look_at_columns(Tile& known, int tile_j, int tile_k, const DepthMap& depths);
    [[nodiscard]] Tile& tile(int j, int k) {
        return tiles_[static_cast<std::size_t>(j) * tiles_along_z_ + static_cast<std::size_t>(k)];
    }

    std::size_t tiles_along_z_ = 0;
    std::vector<Tile> tiles_;
};

}  // namespace snug
