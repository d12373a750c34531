#include "snug/depth/depth_tiles.h"

#include <algorithm>
#include <cmath>

namespace snug {
namespace {

// A plane is of use where it is known well: its errors grow with its slope, and with how thin the triangle
// is.
constexpr double kSteepest = 1000;
constexpr double kThinnest = 1e-3;
// Far above the errors of crossings and of planes that are no steeper and no thinner, for each unit of slope:
// in mm, and as a share of the triangle's length.
constexpr double kSlack = 1e-7;
constexpr double kSlackShare = 1e-11;
// Rectangles that miss a triangle by less count as met (mm).
constexpr double kMargin = 1e-6;
constexpr int kMostIdle = 31;  // triangles

}  // namespace

SpreadTriangle::SpreadTriangle(const std::array<Vec3d, 3>& corners) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d& a = corners[i];
        const Vec3d& b = corners[i == 2 ? 0 : i + 1];
        Edge& edge = edges_[i];
        edge.normal_y = b.z - a.z;
        edge.normal_z = a.y - b.y;
        const auto along = [&edge](const Vec3d& p) { return edge.normal_y * p.y + edge.normal_z * p.z; };
        const auto [least, most] = std::minmax({along(corners[0]), along(corners[1]), along(corners[2])});
        edge.least = least;
        edge.most = most;
        edge.margin = kMargin * (std::abs(edge.normal_y) + std::abs(edge.normal_z));
        own_.include(a.x);
    }
    const Vec3d u = corners[1] - corners[0], v = corners[2] - corners[0];
    const double area = u.y * v.z - u.z * v.y;
    const double longest =
        std::max({std::abs(u.y), std::abs(u.z), std::abs(v.y), std::abs(v.z), std::abs(u.x), std::abs(v.x)});
    if (std::abs(area) > kThinnest * longest * longest) {
        slope_y_ = (u.x * v.z - u.z * v.x) / area;
        slope_z_ = (u.y * v.x - u.x * v.y) / area;
        has_plane_ = std::abs(slope_y_) + std::abs(slope_z_) < kSteepest;
        x0_ = corners[0].x - slope_y_ * corners[0].y - slope_z_ * corners[0].z;
    }
    const double slope = has_plane_ ? std::abs(slope_y_) + std::abs(slope_z_) : 0;
    slack_ = (kSlack + kSlackShare * longest) * (1 + slope);
}

bool SpreadTriangle::may_meet(const Rectangle& r) const {
    for (const Edge& edge : edges_) {
        const double y_low = edge.normal_y * r.y_min, y_high = edge.normal_y * r.y_max;
        const double z_low = edge.normal_z * r.z_min, z_high = edge.normal_z * r.z_max;
        if (std::min(y_low, y_high) + std::min(z_low, z_high) > edge.most + edge.margin ||
            std::max(y_low, y_high) + std::max(z_low, z_high) < edge.least - edge.margin)
            return false;
    }
    return true;
}

bool SpreadTriangle::spans(const Rectangle& r) const {
    // A triangle lies between the line of each edge and the parallel through the corner across.
    for (const Edge& edge : edges_) {
        const double y_low = edge.normal_y * r.y_min, y_high = edge.normal_y * r.y_max;
        const double z_low = edge.normal_z * r.z_min, z_high = edge.normal_z * r.z_max;
        if (std::min(y_low, y_high) + std::min(z_low, z_high) < edge.least + edge.margin ||
            std::max(y_low, y_high) + std::max(z_low, z_high) > edge.most - edge.margin)
            return false;
    }
    return has_plane_;
}

DepthRange SpreadTriangle::over(const Rectangle& r) const {
    DepthRange range;
    if (has_plane_)
        for (const auto& [y, z] : r.corners()) range.include(x_at(y, z));
    else
        range = own_;
    return {std::max(range.lowest, own_.lowest) - slack_, std::min(range.highest, own_.highest) + slack_};
}

DepthTiles::DepthTiles(int rows, int columns)
    : tiles_along_z_(static_cast<std::size_t>((columns + kSide - 1) / kSide)),
      tiles_(static_cast<std::size_t>((rows + kSide - 1) / kSide) * tiles_along_z_) {}

bool DepthTiles::hides(int tile_j, int tile_k, const SpreadTriangle& triangle,
                       const SpreadTriangle::Rectangle& seen, const DepthMap& depths) {
    Tile& known = tile(tile_j, tile_k);
    if (--known.next_look < 0) look_at_columns(known, tile_j, tile_k, depths);
    const DepthRange x = triangle.over(seen);
    bool above = x.highest > known.least_highest, below = x.lowest < known.most_lowest;
    if (!above && !below) return true;
    if (!known.spanned || !triangle.has_plane()) return false;
    bool over = false, under = false;
    const auto corners = seen.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double at = triangle.x_at(corners[i][0], corners[i][1]);
        over |= at + triangle.slack() > known.above[i];
        under |= at - triangle.slack() < known.below[i];
    }
    above &= over;
    below &= under;
    return !above && !below;
}

void DepthTiles::look_at_columns(Tile& known, int tile_j, int tile_k, const DepthMap& depths) {
    double least_highest = std::numeric_limits<double>::infinity();
    double most_lowest = -least_highest;
    const int last_j = std::min((tile_j + 1) * kSide, depths.ny()),
              last_k = std::min((tile_k + 1) * kSide, depths.nz());
    for (int j = tile_j * kSide; j < last_j; ++j)
        for (int k = tile_k * kSide; k < last_k; ++k) {
            const DepthRange& depth = depths(j, k);
            least_highest = std::min(least_highest, depth.highest);
            most_lowest = std::max(most_lowest, depth.lowest);
        }
    // Looks that teach nothing become rare: they cost as much as a triangle.
    const bool learned = least_highest > known.least_highest || most_lowest < known.most_lowest;
    known.idle = learned ? 0 : std::min(2 * known.idle + 1, kMostIdle);
    known.next_look = known.idle;
    known.least_highest = least_highest;
    known.most_lowest = most_lowest;
}

void DepthTiles::added(int tile_j, int tile_k, const SpreadTriangle& triangle,
                       const SpreadTriangle::Rectangle& seen) {
    Tile& known = tile(tile_j, tile_k);
    if (!triangle.spans(seen)) return;
    Plane above, below;
    bool higher = true, lower = true;
    const auto corners = seen.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double at = triangle.x_at(corners[i][0], corners[i][1]);
        above[i] = at - triangle.slack();
        below[i] = at + triangle.slack();
        higher &= above[i] >= known.above[i];
        lower &= below[i] <= known.below[i];
    }
    if (!known.spanned || higher) known.above = above;
    if (!known.spanned || lower) known.below = below;
    known.spanned = true;
    known.next_look = 0;
}

}  // namespace snug
