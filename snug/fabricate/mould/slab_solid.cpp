#include "snug/fabricate/mould/slab_solid.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "snug/fabricate/mould/bored_faces.h"
#include "snug/polygon/plan_faces.h"
#include "snug/polygon/plan_outline.h"
#include "snug/polygon/row_triangulator.h"

namespace snug {
namespace {

bool before_by_y(PlanPoint a, PlanPoint b) {
    return a.y != b.y ? a.y < b.y : a.z < b.z;
}

/// Whether their faces lean the same way but for the rounding to steps.
bool lean_alike(const DraftSlab& a, const DraftSlab& b) {
    const std::int64_t height_a = a.top - a.bottom, height_b = b.top - b.bottom;
    const std::int64_t apart = a.growth * height_b - b.growth * height_a;
    return std::abs(apart) <= height_a + height_b && (a.growth == 0) == (b.growth == 0);
}

bool before_by_z(PlanPoint a, PlanPoint b) {
    return a.z != b.z ? a.z < b.z : a.y < b.y;
}

/// The points of one height at which a vertex may stand, and the vertices there.
class Level {
  public:
    void add(PlanPoint point) { points_.push_back(point); }

    void number(std::uint32_t first_vertex) {
        first_ = first_vertex;
        std::sort(points_.begin(), points_.end(), before_by_y);
        points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
        by_z_ = points_;
        std::sort(by_z_.begin(), by_z_.end(), before_by_z);
    }

    [[nodiscard]] const std::vector<PlanPoint>& points() const { return points_; }
    [[nodiscard]] std::vector<PlanVertex> vertices() const {
        std::vector<PlanVertex> all;
        for (const PlanPoint point : points_)
            all.push_back({point, first_ + static_cast<std::uint32_t>(all.size())});
        return all;
    }
    [[nodiscard]] std::uint32_t vertex(PlanPoint point) const {
        return first_ +
               static_cast<std::uint32_t>(
                   std::lower_bound(points_.begin(), points_.end(), point, before_by_y) - points_.begin());
    }
    /// What lies between two points on one line, in order from `a` to `b`.
    [[nodiscard]] std::vector<PlanPoint> between(PlanPoint a, PlanPoint b) const {
        const bool along_z = a.y == b.y;
        const auto& points = along_z ? points_ : by_z_;
        const auto less = along_z ? before_by_y : before_by_z;
        const bool forward = less(a, b);
        auto first = std::upper_bound(points.begin(), points.end(), forward ? a : b, less);
        auto end = std::lower_bound(first, points.end(), forward ? b : a, less);
        std::vector<PlanPoint> found(first, end);
        if (!forward) std::reverse(found.begin(), found.end());
        return found;
    }

  private:
    std::uint32_t first_ = 0;
    std::vector<PlanPoint> points_, by_z_;
};

using Outline = std::vector<OutlineCorner>;

struct SlabOutline {
    Outline top;
    std::vector<PlanPoint> bottom;  // in the corners' order
    /// For the face behind each corner: the corner of the slab below behind which it goes straight on.
    std::vector<std::uint32_t> goes_on;
    std::vector<char> begins;  // it does not come straight from above
    std::vector<char> passed;  // at the bottom both faces beside the corner go on: no vertex
};

class SlabMesher {
  public:
    SlabMesher(std::span<const DraftSlab> slabs, const PlanBox& box, std::span<const SlabBore> bores)
        : slabs_(slabs), box_(box), outlines_(slabs.size()), levels_(slabs.size() + 1), bored_(bores) {}

    StepSolid mesh() {
        number_vertices();
        for (std::size_t i = 0; i + 1 < slabs_.size(); ++i) find_what_goes_on(i);
        for (std::size_t i = 0; i < slabs_.size(); ++i) add_walls(i);
        for (std::size_t i = 0; i <= slabs_.size(); ++i) add_level(i);
        bored_.add_to(solid_);
        drop_unused();
        return std::move(solid_);
    }

  private:
    void number_vertices() {
        for (std::size_t i = 0; i < slabs_.size(); ++i) {
            SlabOutline& outline = outlines_[i];
            outline.top = outline_corners(slabs_[i].region);
            outline.bottom = offset_corners(outline.top, slabs_[i].growth, box_);
            outline.goes_on.assign(outline.top.size(), kNoVertex);
            outline.begins.assign(outline.top.size(), 1);
            outline.passed.assign(outline.top.size(), 0);
            for (const OutlineCorner& corner : outline.top) levels_[i].add(corner.at);
            for (const PlanPoint point : outline.bottom) levels_[i + 1].add(point);
        }
        for (std::size_t i = 0; i < levels_.size(); ++i) {
            levels_[i].number(static_cast<std::uint32_t>(solid_.points.size()));
            const int height = i == 0 ? slabs_[0].top : slabs_[i - 1].bottom;
            for (const PlanPoint p : levels_[i].points()) solid_.points.push_back({height, p.y, p.z});
        }
    }

    [[nodiscard]] bool on_side(PlanPoint a, PlanPoint b) const {
        return a.y == b.y ? a.y == box_.least.y || a.y == box_.greatest.y
                          : a.z == box_.least.z || a.z == box_.greatest.z;
    }

    void find_what_goes_on(std::size_t i) {
        SlabOutline &outline = outlines_[i], &below = outlines_[i + 1];
        const bool same_lean = lean_alike(slabs_[i], slabs_[i + 1]);
        for (std::size_t c = 0; c < outline.top.size(); ++c) {
            const PlanPoint a = outline.bottom[c], b = outline.bottom[outline.top[c].next];
            if (!same_lean && !on_side(a, b)) continue;
            const auto found = std::lower_bound(
                below.top.begin(), below.top.end(), a,
                [](const OutlineCorner& corner, PlanPoint p) { return before_by_y(corner.at, p); });
            if (found == below.top.end() || !(found->at == a) || !(below.top[found->next].at == b)) continue;
            if (!levels_[i + 1].between(a, b).empty()) continue;
            outline.goes_on[c] = static_cast<std::uint32_t>(found - below.top.begin());
            below.begins[outline.goes_on[c]] = 0;
        }
        for (std::size_t c = 0; c < outline.top.size(); ++c)
            outline.passed[c] =
                outline.goes_on[c] != kNoVertex && outline.goes_on[outline.top[c].previous] != kNoVertex;
    }

    /// Every face that begins in slab `first`, down to where it ends.
    void add_walls(std::size_t first) {
        for (std::size_t c = 0; c < outlines_[first].top.size(); ++c)
            if (outlines_[first].begins[c]) add_wall(first, c);
    }

    void add_wall(std::size_t slab, std::size_t corner) {
        const Outline& top = outlines_[slab].top;
        const PlanPoint from = top[corner].at, to = top[top[corner].next].at;
        // Vertices along each side; the left and right ones from the top down.
        std::vector<std::uint32_t> above = chain(slab, from, to), left{above.front()}, right{above.back()};
        while (true) {
            const SlabOutline& outline = outlines_[slab];
            const std::size_t next = outline.top[corner].next;
            const bool last = outline.goes_on[corner] == kNoVertex;
            if (last || !outline.passed[corner])
                left.push_back(levels_[slab + 1].vertex(outline.bottom[corner]));
            if (last || !outline.passed[next])
                right.push_back(levels_[slab + 1].vertex(outline.bottom[next]));
            if (last) {
                const auto below = chain(slab + 1, outline.bottom[corner], outline.bottom[next]);
                add_wall(side_of(from, to), above, left, right, below);
                return;
            }
            corner = outline.goes_on[corner];
            ++slab;
        }
    }

    [[nodiscard]] std::vector<std::uint32_t> chain(std::size_t level, PlanPoint from, PlanPoint to) const {
        std::vector<std::uint32_t> vertices{levels_[level].vertex(from)};
        for (const PlanPoint p : levels_[level].between(from, to))
            vertices.push_back(levels_[level].vertex(p));
        vertices.push_back(levels_[level].vertex(to));
        return vertices;
    }

    /// The side of the box that a face lies on; axis 0 for none.
    [[nodiscard]] BoredSide side_of(PlanPoint from, PlanPoint to) const {
        if (!on_side(from, to)) return {0, false};
        return from.y == to.y ? BoredSide{1, from.y == box_.least.y} : BoredSide{2, from.z == box_.least.z};
    }

    /// Two fans with the vertices along the bottom and the top, and between them a strip: no triangle has all
    /// its corners on one side.
    void add_wall(BoredSide side, const std::vector<std::uint32_t>& above,
                  const std::vector<std::uint32_t>& left, const std::vector<std::uint32_t>& right,
                  const std::vector<std::uint32_t>& below) {
        if (side.axis != 0 && bored_.has(side)) {
            bored_.add_edges(side, below);
            bored_.add_edges(side, {right.rbegin(), right.rend()});
            bored_.add_edges(side, {above.rbegin(), above.rend()});
            bored_.add_edges(side, left);
            return;
        }
        auto& triangles = solid_.triangles;
        std::size_t l = left.size() - 2, r = right.size() - 1;
        for (std::size_t i = 0; i + 1 < below.size(); ++i)
            triangles.push_back({below[i], below[i + 1], left[l]});
        while (l > 0 || r > 1) {
            const bool up_left = r == 1 || (l > 0 && height(left[l - 1]) < height(right[r - 1]));
            triangles.push_back({right[r], up_left ? left[l - 1] : right[r - 1], left[l]});
            --(up_left ? l : r);
        }
        for (std::size_t i = 0; i + 1 < above.size(); ++i)
            triangles.push_back({right[1], above[i + 1], above[i]});
    }

    [[nodiscard]] int height(std::uint32_t vertex) const { return solid_.points[vertex].x; }

    /// The faces that look up at a height, or the base.
    void add_level(std::size_t i) {
        const bool base = i == slabs_.size();
        const BoredSide side{0, base};
        if ((i == 0 || base) && bored_.has(side)) return add_bored_level(side);
        const PlanRegion face = base     ? bottom_of(slabs_[i - 1], box_)
                                : i == 0 ? slabs_[0].region
                                         : difference(slabs_[i].region, bottom_of(slabs_[i - 1], box_));
        triangulate(face, levels_[i].vertices(), base ? -1 : 1, solid_.triangles);
    }

    void add_bored_level(BoredSide side) {
        const SlabOutline& outline = side.low ? outlines_.back() : outlines_.front();
        const Level& level = side.low ? levels_.back() : levels_.front();
        for (std::size_t c = 0; c < outline.top.size(); ++c) {
            const std::size_t next = outline.top[c].next;
            const std::uint32_t a = level.vertex(side.low ? outline.bottom[c] : outline.top[c].at);
            const std::uint32_t b = level.vertex(side.low ? outline.bottom[next] : outline.top[next].at);
            bored_.add_edges(side, side.low ? std::vector{b, a} : std::vector{a, b});
        }
    }

    void drop_unused() {
        std::vector<std::uint32_t> number(solid_.points.size(), kNoVertex);
        std::vector<Vec3i> used;
        for (Triangle& triangle : solid_.triangles)
            for (std::uint32_t& vertex : triangle) {
                if (number[vertex] == kNoVertex) {
                    number[vertex] = static_cast<std::uint32_t>(used.size());
                    used.push_back(solid_.points[vertex]);
                }
                vertex = number[vertex];
            }
        solid_.points = std::move(used);
    }

    std::span<const DraftSlab> slabs_;
    PlanBox box_;
    std::vector<SlabOutline> outlines_;
    std::vector<Level> levels_;
    BoredFaces bored_;
    StepSolid solid_;
};

}  // namespace

StepSolid slab_solid(std::span<const DraftSlab> slabs, const PlanBox& box, std::span<const SlabBore> bores) {
    return slabs.empty() ? StepSolid{} : SlabMesher(slabs, box, bores).mesh();
}

}  // namespace snug
