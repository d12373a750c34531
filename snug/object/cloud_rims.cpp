#include "snug/object/cloud_rims.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>

#include "snug/base/parallel.h"
#include "snug/base/symmetric.h"
#include "snug/base/vec2.h"

namespace snug {
namespace {

constexpr std::size_t kRimNeighbours = CloudPlaces::kMostNeighbours;
constexpr std::size_t kChunk = 4096;   // points that one task treats
constexpr double kCosineOfGap = -0.5;  // 120 degrees
/// Below this share of the longest extent squared the neighbours lie in a line, such as a wire's, and say
/// nothing of a surface.
constexpr double kLine = 0.02;
/// Rim points are in a row where they are not farther from each other than this many times the farthest of
/// their neighbours: a row has gaps where the points lie at random.
constexpr double kInARow = 1.4;
constexpr std::size_t kLeastRim = 12;  // points

Vec2d seen_along(Vec3d p, const PrincipalAxes& axes) {
    return {dot(p, axes.axis[0]), dot(p, axes.axis[1])};
}

double cross(Vec2d a, Vec2d b) {
    return a.x * b.y - a.y * b.x;
}

/// Grows with the angle from -180 to 180 degrees, without a sine.
double angle_order(Vec2d d) {
    const double slope = d.x / (std::fabs(d.x) + std::fabs(d.y));
    return d.y < 0 ? slope - 1 : 1 - slope;
}

bool has_gap(std::vector<std::pair<double, Vec2d>>& around) {
    std::sort(around.begin(), around.end(), [](const auto& a, const auto& b) {
        return std::tie(a.first, a.second.x, a.second.y) < std::tie(b.first, b.second.x, b.second.y);
    });
    for (std::size_t i = 0; i < around.size(); ++i) {
        const Vec2d a = around[i].second, b = around[(i + 1) % around.size()].second;
        const double sine = cross(a, b), cosine = a.x * b.x + a.y * b.y;
        const double lengths = std::sqrt((a.x * a.x + a.y * a.y) * (b.x * b.x + b.y * b.y));
        const bool several = around.size() > 1;
        if (!several || sine < 0 || cosine < kCosineOfGap * lengths) return true;
    }
    return false;
}

/// The squared distance to the farthest neighbour of a place on a rim; 0 for any other.
double rim_width(const CloudPlaces& places, std::size_t place) {
    const CloudPlaces::Neighbours nearest = places.nearest(place, kRimNeighbours);
    if (nearest.count < kRimNeighbours) return 0;
    const Vec3d own = places.position(place);
    Vec3d middle;
    for (std::size_t n = 0; n < nearest.count; ++n) middle = middle + places.position(nearest.place[n]);
    middle = middle * (1.0 / static_cast<double>(nearest.count));
    Symmetric spread;
    for (std::size_t n = 0; n < nearest.count; ++n)
        spread.add_square(places.position(nearest.place[n]) - middle);
    const PrincipalAxes axes = principal_axes(spread);
    if (axes.value[1] <= kLine * axes.value[0]) return 0;
    std::vector<std::pair<double, Vec2d>> around;
    around.reserve(nearest.count);
    for (std::size_t n = 0; n < nearest.count; ++n) {
        const Vec2d seen = seen_along(places.position(nearest.place[n]) - own, axes);
        if (seen.x != 0 || seen.y != 0) around.push_back({angle_order(seen), seen});
    }
    return has_gap(around) ? nearest.squared[kRimNeighbours - 1] : 0;
}

/// The places on rims alone, as a cloud, and what rim_width() says of each.
struct RimPoints {
    Mesh cloud;
    std::vector<std::uint32_t> place;
    std::vector<double> width;
};

RimPoints rim_points(const CloudPlaces& places) {
    std::vector<double> width(places.size(), 0);
    parallel_for((width.size() + kChunk - 1) / kChunk, [&](std::size_t chunk) {
        const std::size_t end = std::min(width.size(), (chunk + 1) * kChunk);
        for (std::size_t i = chunk * kChunk; i < end; ++i) width[i] = rim_width(places, i);
    });
    RimPoints rim;
    for (std::uint32_t i = 0; i < width.size(); ++i) {
        if (width[i] == 0) continue;
        rim.cloud.vertices.push_back(vec_cast<float>(places.position(i)));
        rim.place.push_back(i);
        rim.width.push_back(width[i]);
    }
    return rim;
}

/// Rim points that are in a row, as places, each row in their order.
std::vector<std::vector<std::uint32_t>> rows_of(const RimPoints& rim) {
    std::vector<std::uint32_t> parent(rim.place.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&parent](std::uint32_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    const CloudPlaces near(rim.cloud);
    for (std::uint32_t i = 0; i < parent.size(); ++i) {
        const CloudPlaces::Neighbours nearest = near.nearest(near.of_vertex(i), kRimNeighbours);
        for (std::size_t n = 0; n < nearest.count; ++n) {
            if (nearest.squared[n] > kInARow * kInARow * rim.width[i]) continue;
            const std::uint32_t a = root(i), b = root(near.vertex_of(nearest.place[n]));
            parent[std::max(a, b)] = std::min(a, b);
        }
    }
    std::vector<std::vector<std::uint32_t>> rows;
    std::vector<std::uint32_t> row_of(parent.size(), 0);  // number + 1, at roots
    for (std::uint32_t i = 0; i < parent.size(); ++i) {
        std::uint32_t& row = row_of[root(i)];
        if (row == 0) {
            rows.emplace_back();
            row = static_cast<std::uint32_t>(rows.size());
        }
        rows[row - 1].push_back(rim.place[i]);
    }
    return rows;
}

/// The convex outline of a row, seen in the plane in which it lies most (Andrew's monotone chain).
std::vector<std::uint32_t> outline(const CloudPlaces& places, const std::vector<std::uint32_t>& row) {
    Vec3d middle;
    for (const std::uint32_t place : row) middle = middle + places.position(place);
    middle = middle * (1.0 / static_cast<double>(row.size()));
    Symmetric spread;
    for (const std::uint32_t place : row) spread.add_square(places.position(place) - middle);
    const PrincipalAxes axes = principal_axes(spread);
    std::vector<std::pair<Vec2d, std::uint32_t>> points;
    for (const std::uint32_t place : row)
        points.push_back({seen_along(places.position(place) - middle, axes), place});
    std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
        return std::tie(a.first.x, a.first.y, a.second) < std::tie(b.first.x, b.first.y, b.second);
    });
    std::vector<std::pair<Vec2d, std::uint32_t>> hull;
    const auto add_chain = [&hull](auto begin, auto end) {
        const std::size_t base = hull.size();
        for (auto at = begin; at != end; ++at) {
            while (hull.size() >= base + 2) {
                const Vec2d a = hull[hull.size() - 2].first, b = hull.back().first, c = at->first;
                if (cross({b.x - a.x, b.y - a.y}, {c.x - a.x, c.y - a.y}) > 0) break;
                hull.pop_back();
            }
            hull.push_back(*at);
        }
        hull.pop_back();  // begins the other chain
    };
    add_chain(points.begin(), points.end());
    add_chain(points.rbegin(), points.rend());
    std::vector<std::uint32_t> loop;
    for (const auto& [seen, place] : hull) loop.push_back(places.vertex_of(place));
    return loop;
}

}  // namespace

std::vector<std::vector<std::uint32_t>> cloud_rims(const CloudPlaces& places) {
    std::vector<std::vector<std::uint32_t>> loops;
    for (const std::vector<std::uint32_t>& row : rows_of(rim_points(places))) {
        if (row.size() < kLeastRim) continue;
        std::vector<std::uint32_t> loop = outline(places, row);
        if (loop.size() >= 3) loops.push_back(std::move(loop));
    }
    return loops;
}

}  // namespace snug
