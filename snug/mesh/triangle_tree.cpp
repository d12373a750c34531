#include "snug/mesh/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace snug {
namespace {

constexpr int kMortonBits = 16;
constexpr int kBitsPerPass = 12;

struct CurvePlace {
    std::uint64_t code;
    std::uint32_t triangle;
};

/// Moves bit i of a 16-bit number to bit 3 i.
std::uint64_t spread_bits(std::uint64_t v) {
    v = (v | (v << 16)) & 0x0000'0000'ff00'00ffu;
    v = (v | (v << 8)) & 0x0000'00f0'0f00'f00fu;
    v = (v | (v << 4)) & 0x0000'0c30'c30c'30c3u;
    v = (v | (v << 2)) & 0x0000'2492'4924'9249u;
    return v;
}

/// Where the triangles lie along a Morton curve that fills their bounding box.
std::vector<CurvePlace> places_on_curve(std::span<const Vec3d> vertices,
                                        std::span<const Triangle> triangles) {
    Box3d bounds;
    for (const Vec3d& v : vertices) bounds.include(v);
    constexpr double kCells = 1 << kMortonBits;
    // One scale for all axes keeps the curve's cells cubes.
    const double longest = bounds.longest_side();
    const double cells_per_unit = longest > 0 ? (kCells - 1) / longest : 0;
    std::vector<CurvePlace> places(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        const Vec3d sum =
            (vertices[t[0]] - bounds.min) + (vertices[t[1]] - bounds.min) + (vertices[t[2]] - bounds.min);
        const Vec3d cell = sum * (cells_per_unit / 3);
        const auto bits = [](double c) {
            return spread_bits(static_cast<std::uint64_t>(std::clamp(c, 0.0, kCells - 1)));
        };
        places[i] = {bits(cell.x) << 2 | bits(cell.y) << 1 | bits(cell.z), static_cast<std::uint32_t>(i)};
    }
    return places;
}

/// One pass of a radix sort, which keeps the order of equal digits.
void sort_by_digit(const std::vector<CurvePlace>& from, std::vector<CurvePlace>& to, int shift) {
    constexpr std::uint64_t kMask = (1u << kBitsPerPass) - 1;
    std::vector<std::size_t> next((1u << kBitsPerPass) + 1, 0);
    for (const CurvePlace& p : from) ++next[((p.code >> shift) & kMask) + 1];
    for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
    for (const CurvePlace& p : from) to[next[(p.code >> shift) & kMask]++] = p;
}

float rounded_down(double value) {
    const auto f = static_cast<float>(value);
    return f > value ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}

float rounded_up(double value) {
    const auto f = static_cast<float>(value);
    return f < value ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

double squared(Vec3d v) {
    return dot(v, v);
}

double outside_interval(double value, double low, double high) {
    return std::max(std::max(low - value, value - high), 0.0);
}

Vec3d nearest_on_segment(Vec3d a, Vec3d b, Vec3d p) {
    const Vec3d ab = b - a;
    const double length2 = squared(ab);
    if (length2 <= 0) return a;
    return a + ab * std::clamp(dot(p - a, ab) / length2, 0.0, 1.0);
}

}  // namespace

Vec3d nearest_on_triangle(Vec3d a, Vec3d b, Vec3d c, Vec3d p) {
    const Vec3d normal = cross(b - a, c - a);
    const double normal2 = squared(normal);
    const std::array<std::pair<Vec3d, Vec3d>, 3> edges{{{a, b}, {b, c}, {c, a}}};
    // Seen along the normal, the nearest point lies on an edge that p is beyond, or under p itself.
    std::optional<Vec3d> nearest;
    for (const auto& [from, to] : edges) {
        if (normal2 > 0 && dot(cross(normal, to - from), p - from) >= 0) continue;
        const Vec3d candidate = nearest_on_segment(from, to, p);
        if (!nearest || squared(candidate - p) < squared(*nearest - p)) nearest = candidate;
    }
    return nearest ? *nearest : p - normal * (dot(normal, p - a) / normal2);
}

Result<TriangleTree> TriangleTree::build(std::span<const Vec3d> vertices, std::span<const Triangle> triangles,
                                         const Progress& progress) {
    constexpr double kSteps = 7;
    double step = 0;
    const auto cancelled = [&] { return !go_on(progress, std::min(++step / kSteps, 1.0)); };
    const auto failure = [] { return fail(ErrorKind::cancelled, say("cancelled")); };

    std::vector<CurvePlace> places = places_on_curve(vertices, triangles);
    if (cancelled()) return failure();
    std::vector<CurvePlace> sorted(places.size());
    for (int shift = 0; shift < 3 * kMortonBits; shift += kBitsPerPass) {
        sort_by_digit(places, sorted, shift);
        places.swap(sorted);
        if (cancelled()) return failure();
    }
    TriangleTree tree;
    tree.vertices_ = vertices;
    tree.triangles_.reserve(triangles.size());
    for (const CurvePlace& p : places) tree.triangles_.push_back(triangles[p.triangle]);
    if (cancelled()) return failure();
    tree.build_leaves();
    while (tree.levels_.back().size() > 1) tree.build_level_above();
    if (cancelled()) return failure();
    return tree;
}

void TriangleTree::build_leaves() {
    std::vector<FloatBox> leaves((triangles_.size() + kFanOut - 1) / kFanOut);
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        Box3d bounds;
        const std::size_t end = std::min((i + 1) * kFanOut, triangles_.size());
        for (std::size_t t = i * kFanOut; t < end; ++t) {
            for (const std::uint32_t v : triangles_[t]) bounds.include(vertices_[v]);
        }
        leaves[i] = {{rounded_down(bounds.min.x), rounded_down(bounds.min.y), rounded_down(bounds.min.z)},
                     {rounded_up(bounds.max.x), rounded_up(bounds.max.y), rounded_up(bounds.max.z)}};
    }
    levels_.push_back(std::move(leaves));
}

void TriangleTree::build_level_above() {
    const std::vector<FloatBox>& children = levels_.back();
    std::vector<FloatBox> parents((children.size() + kFanOut - 1) / kFanOut);
    for (std::size_t i = 0; i < parents.size(); ++i) {
        FloatBox all = children[i * kFanOut];
        const std::size_t end = std::min((i + 1) * kFanOut, children.size());
        for (std::size_t c = i * kFanOut + 1; c < end; ++c) {
            for (int axis = 0; axis < 3; ++axis) {
                all.min[axis] = std::min(all.min[axis], children[c].min[axis]);
                all.max[axis] = std::max(all.max[axis], children[c].max[axis]);
            }
        }
        parents[i] = all;
    }
    levels_.push_back(std::move(parents));
}

NearestPoint TriangleTree::nearest(Vec3d p, double at_most, double enough) const {
    NearestPoint best{{}, at_most, 0};
    std::uint32_t looked_at = 0;
    if (triangles_.empty()) return best;
    struct Branch {
        double distance2;
        Node node;
    };
    double best2 = at_most * at_most;
    const double enough2 = enough > 0 ? enough * enough : -1;
    const auto branch = [&](Node node) {
        const FloatBox& b = box(node);
        const Vec3d gap{outside_interval(p.x, b.min.x, b.max.x), outside_interval(p.y, b.min.y, b.max.y),
                        outside_interval(p.z, b.min.z, b.max.z)};
        return Branch{squared(gap), node};
    };
    std::array<Branch, kMostLevels * kFanOut> stack;
    std::size_t waiting = 0;
    stack[waiting++] = branch(root());
    while (waiting > 0 && best2 > enough2) {
        const Branch next = stack[--waiting];
        if (next.distance2 >= best2) continue;
        const Range range = below(next.node);
        looked_at += static_cast<std::uint32_t>(range.end - range.first) *
                     (next.node.level == 0 ? NearestPoint::kLooksOfTriangle : 1);
        if (next.node.level == 0) {
            for (std::size_t i = range.first; i < range.end; ++i) {
                const Triangle& t = triangles_[i];
                const Vec3d q = nearest_on_triangle(vertices_[t[0]], vertices_[t[1]], vertices_[t[2]], p);
                const double distance2 = squared(q - p);
                if (distance2 >= best2) continue;
                best2 = distance2;
                best = {q, std::sqrt(distance2), 0};
            }
            continue;
        }
        // The nearest child comes last, so that it is taken first.
        const std::size_t bottom = waiting;
        for (std::size_t i = range.first; i < range.end; ++i) {
            const Branch child = branch({next.node.level - 1, static_cast<std::uint32_t>(i)});
            if (child.distance2 >= best2) continue;
            std::size_t place = waiting++;
            for (; place > bottom && stack[place - 1].distance2 < child.distance2; --place)
                stack[place] = stack[place - 1];
            stack[place] = child;
        }
    }
    best.looked_at = looked_at;
    return best;
}

}  // namespace snug
