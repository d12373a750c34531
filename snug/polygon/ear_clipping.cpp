#include "snug/polygon/ear_clipping.h"

#include <algorithm>
#include <cmath>

#include "snug/polygon/polygon.h"

namespace snug {
namespace {

constexpr int kMostLooks = 2;  // over all corners, at polygons that touch themselves

/// Cuts corner after corner off, each a triangle that holds no other corner.
class EarClipper {
  public:
    EarClipper(std::span<const Vec2d> points, double flat)
        : points_(points), left_(points.size()), flat_(flat), corners_(points.size()) {
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
        return orientation(points_[corners_[at].before], points_[at], points_[corners_[at].after]);
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
        const Vec2d a = points_[corners_[at].before], b = points_[at], c = points_[corners_[at].after];
        if (a == b || b == c) return true;  // a corner given twice
        if (!(orientation(a, b, c) > 0)) return false;
        const auto [low_x, high_x] = std::minmax({a.x, b.x, c.x});
        const auto [low_y, high_y] = std::minmax({a.y, b.y, c.y});
        for (const std::size_t other : reflex_) {
            const Vec2d p = points_[other];
            if (p.x < low_x || p.x > high_x || p.y < low_y || p.y > high_y) continue;
            if (p == a || p == b || p == c) continue;
            if (orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0)
                return false;
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

    std::span<const Vec2d> points_;
    std::size_t left_;
    double flat_;
    std::vector<Corner> corners_;
    std::vector<std::size_t> reflex_;
    std::vector<std::size_t> to_test_;
    std::size_t tested_ = 0;
    std::size_t latest_ = 0;
};

}  // namespace

bool clip_ears(std::span<const Vec2d> polygon, double flat,
               std::vector<std::array<std::size_t, 3>>& triangles) {
    triangles.reserve(triangles.size() + polygon.size());
    return EarClipper(polygon, flat).clip(triangles);
}

}  // namespace snug
