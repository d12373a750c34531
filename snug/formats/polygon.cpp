#include <algorithm>
#include <array>
#include <cmath>

#include "snug/mesh/raw_mesh.h"

namespace snug {
namespace {

constexpr std::size_t kMostCornersToClip = 1000;  // the time goes with the square of this
constexpr int kMostLooks = 2;                     // over all corners, at polygons that touch themselves
constexpr double kFlat = 1e-12;                   // of the polygon's area: a corner that rounding left over

struct Point {
    double u = 0, v = 0;
    friend bool operator==(const Point&, const Point&) = default;
};

double turn(Point a, Point b, Point c) {
    return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

/// The corners seen along the polygon's area vector, so that it runs counter-clockwise: the coordinate along
/// which the area is largest is dropped, which keeps what is inside what. Gives twice the area seen so.
template <class T>
double flatten(const RawMeshOf<T>& mesh, std::span<const std::uint32_t> corners, std::span<Point> points) {
    const auto place = [&](std::size_t i) { return vec_cast<double>(mesh.vertices[corners[i]]); };
    const Vec3d base = place(0);
    Vec3d area;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        area = area + cross(place(i) - base, place(i + 1) - base);
    int axis = 0;
    for (int other = 1; other < 3; ++other)
        if (std::fabs(area[other]) > std::fabs(area[axis])) axis = other;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const bool mirrored = area[axis] < 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3d p = place(i) - base;
        points[i] = mirrored ? Point{p[v], p[u]} : Point{p[u], p[v]};
    }
    return std::fabs(area[axis]);
}

/// Triangles that all run the polygon's way round and have its outline together cover its inside once and
/// nothing else: each point is covered as often as the outline goes round it.
bool fan_stays_inside(std::span<const Point> points) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        if (turn(points[0], points[i], points[i + 1]) < 0) return false;
    return true;
}

/// Cuts corner after corner off, each a triangle that holds no other corner.
class EarClipper {
  public:
    EarClipper(std::span<const Point> points, double area)
        : points_(points), left_(points.size()), flat_(kFlat * area), corners_(points.size()) {
        for (std::size_t i = 0; i < left_; ++i) {
            corners_[i].before = (i + left_ - 1) % left_;
            corners_[i].after = (i + 1) % left_;
        }
        for (std::size_t i = 0; i < left_; ++i) list_if_reflex(i);
    }

    /// The triangles as places of corners; fails on polygons that cross themselves.
    bool clip(std::vector<std::array<std::size_t, 3>>& triangles) {
        std::size_t left_before = left_ + 1;
        for (int look = 0; look < kMostLooks && left_ > 3 && left_ < left_before; ++look) {
            left_before = left_;
            look_at_all();
            while (left_ > 3) {
                const std::size_t at = next_ear();
                if (at == points_.size()) break;
                triangles.push_back(cut(at));
            }
        }
        if (left_ > 3) return false;
        const std::size_t last = corners_[latest_].after;
        triangles.push_back({corners_[last].before, last, corners_[last].after});
        return turn_at(last) >= -flat_;
    }

  private:
    struct Corner {
        std::size_t before = 0, after = 0;
        bool is_cut = false, is_reflex = false;
    };

    double turn_at(std::size_t at) const {
        return turn(points_[corners_[at].before], points_[at], points_[corners_[at].after]);
    }

    void look_at_all() {
        to_test_.clear();
        tested_ = 0;
        for (std::size_t i = 0; i < points_.size(); ++i)
            if (!corners_[i].is_cut) to_test_.push_back(i);
    }

    /// Cutting an ear off changes its two neighbours only, so only they are tested again. Where none is left,
    /// a corner that is flat but for rounding can go without harm. points_.size() if there is none either.
    std::size_t next_ear() {
        while (tested_ < to_test_.size()) {
            const std::size_t at = to_test_[tested_++];
            if (!corners_[at].is_cut && is_ear(at)) return at;
        }
        for (std::size_t i = 0; i < points_.size(); ++i)
            if (!corners_[i].is_cut && std::fabs(turn_at(i)) <= flat_) return i;
        return points_.size();
    }

    /// Only reflex corners can be the first to reach into a triangle. Those at the very place of one of its
    /// corners belong to a bridge to a hole and do not.
    bool is_ear(std::size_t at) const {
        const Point a = points_[corners_[at].before], b = points_[at], c = points_[corners_[at].after];
        if (a == b || b == c) return true;  // a corner given twice
        if (!(turn(a, b, c) > 0)) return false;
        const auto [low_u, high_u] = std::minmax({a.u, b.u, c.u});
        const auto [low_v, high_v] = std::minmax({a.v, b.v, c.v});
        for (const std::size_t other : reflex_) {
            const Point p = points_[other];
            if (p.u < low_u || p.u > high_u || p.v < low_v || p.v > high_v) continue;
            if (p == a || p == b || p == c) continue;
            if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
        }
        return true;
    }

    std::array<std::size_t, 3> cut(std::size_t at) {
        const std::size_t before = corners_[at].before, after = corners_[at].after;
        corners_[at].is_cut = true;
        corners_[before].after = after;
        corners_[after].before = before;
        --left_;
        latest_ = before;
        for (const std::size_t changed : {before, at, after}) list_if_reflex(changed);
        to_test_.push_back(before);
        to_test_.push_back(after);
        return {before, at, after};
    }

    void list_if_reflex(std::size_t at) {
        const bool reflex = !corners_[at].is_cut && turn_at(at) <= 0;
        if (reflex == corners_[at].is_reflex) return;
        corners_[at].is_reflex = reflex;
        if (reflex) {
            reflex_.push_back(at);
        } else {
            *std::find(reflex_.begin(), reflex_.end(), at) = reflex_.back();
            reflex_.pop_back();
        }
    }

    std::span<const Point> points_;
    std::size_t left_;
    double flat_;
    std::vector<Corner> corners_;
    std::vector<std::size_t> reflex_;
    std::vector<std::size_t> to_test_;
    std::size_t tested_ = 0;
    std::size_t latest_ = 0;
};

/// Fails, leaving the triangles as they were, on polygons that cross themselves.
bool clip_ears(std::vector<Triangle>& into, std::span<const std::uint32_t> corners,
               std::span<const Point> points, double area) {
    std::vector<std::array<std::size_t, 3>> triangles;
    triangles.reserve(points.size());
    if (!EarClipper(points, area).clip(triangles)) return false;
    for (const auto& [a, b, c] : triangles) into.push_back({corners[a], corners[b], corners[c]});
    return true;
}

template <class T>
bool clip_where_a_fan_would_leave(RawMeshOf<T>& mesh, std::span<const std::uint32_t> corners) {
    std::array<Point, 8> few;
    std::vector<Point> many(corners.size() > few.size() ? corners.size() : 0);
    const std::span<Point> points = many.empty() ? std::span<Point>(few).first(corners.size()) : many;
    const double area = flatten(mesh, corners, points);
    return !fan_stays_inside(points) && clip_ears(mesh.triangles, corners, points, area);
}

}  // namespace

template <class T>
void append_polygon(RawMeshOf<T>& mesh, std::span<const std::uint32_t> corners) {
    const auto wrong = [&](std::uint32_t v) { return !usable(mesh.vertices[v]); };
    if (corners.size() < 3 || (corners.size() > 3 && std::any_of(corners.begin(), corners.end(), wrong))) {
        ++mesh.read.left_out_faces;
        return;
    }
    if (corners.size() > 3 && corners.size() <= kMostCornersToClip &&
        clip_where_a_fan_would_leave(mesh, corners))
        return;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        mesh.triangles.push_back({corners[0], corners[i], corners[i + 1]});
}

template void append_polygon(RawMeshOf<float>&, std::span<const std::uint32_t>);
template void append_polygon(RawMeshOf<double>&, std::span<const std::uint32_t>);

}  // namespace snug
