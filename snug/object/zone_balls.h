#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "snug/base/box.h"
#include "snug/base/vec.h"
#include "snug/design/zone.h"

namespace snug {

/// The balls of a zone in an object's own coordinates, to be asked of many triangles.
class ZoneBalls {
  public:
    /// `origin`: where the object's (0, 0, 0) lies in the zone's coordinates. Balls are grown by `grown_mm`.
    ZoneBalls(const Zone& zone, Vec3d origin, double grown_mm = 0);

    using Corners = std::array<Vec3d, 3>;
    /// Whether any ball meets the triangle, bounds included.
    [[nodiscard]] bool meet(const Corners& triangle) const;
    /// Whether any ball meets another.
    [[nodiscard]] bool meet(Vec3d centre, double radius) const;
    /// The pieces of a triangle that balls meet, to be appended to `pieces`.
    void add_pieces(const Corners& triangle, std::vector<Corners>& pieces) const;
    [[nodiscard]] const Box3d& bounds() const { return bounds_; }

  private:
    struct Ball {
        Vec3d centre;
        double radius = 0;
    };
    /// Visits balls that may meet the box until `visit` returns true.
    template <class Visit>
    bool any_near(const Box3d& box, Visit visit) const;
    [[nodiscard]] std::array<std::int32_t, 6> cells(const Box3d& box) const;

    static constexpr std::int32_t kCells = 16;  // along each axis
    std::vector<Ball> balls_;                   // the largest first, none within another
    Box3d bounds_;
    Vec3d cell_mm_;
    std::vector<std::vector<std::uint16_t>> in_cell_;
};

}  // namespace snug
