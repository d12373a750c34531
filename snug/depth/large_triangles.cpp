#include "snug/depth/large_triangles.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "snug/depth/depth_map.h"

namespace snug {
namespace {

struct Large {
    double outward;                                ///< how far it reaches from the middle
    std::array<std::array<double, 3>, 3> corners;  ///< the least one first
    std::uint32_t triangle;

    [[nodiscard]] auto key() const { return std::tie(corners, triangle); }
};

Large large(const Triangle& t, std::span<const Vec3d> placed, std::uint32_t index) {
    Large found{0, {}, index};
    for (std::size_t i = 0; i < 3; ++i) found.corners[i] = {placed[t[i]].x, placed[t[i]].y, placed[t[i]].z};
    // The order of the corners but not their direction: crossings of an edge are rounded from its beginning.
    std::rotate(found.corners.begin(), std::min_element(found.corners.begin(), found.corners.end()),
                found.corners.end());
    return found;
}

}  // namespace

std::vector<std::uint32_t> outermost_first(std::span<const Triangle> triangles,
                                           std::span<const std::uint8_t> marked,
                                           std::span<const Vec3d> placed) {
    std::vector<Large> found;
    DepthRange x;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (marked[t] == 0) continue;
        found.push_back(large(triangles[t], placed, static_cast<std::uint32_t>(t)));
        for (const auto& corner : found.back().corners) x.include(corner[0]);
    }
    const double middle = (x.lowest + x.highest) / 2;
    for (Large& each : found)
        for (const auto& corner : each.corners)
            each.outward = std::max({each.outward, corner[0] - middle, middle - corner[0]});
    std::sort(found.begin(), found.end(), [](const Large& a, const Large& b) {
        return a.outward != b.outward ? a.outward > b.outward : a.key() < b.key();
    });
    std::vector<std::uint32_t> order;
    order.reserve(found.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        if (i == 0 || found[i].corners != found[i - 1].corners) order.push_back(found[i].triangle);
    return order;
}

}  // namespace snug
