#include "snug/samples/sample_solids.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "snug/base/rotation.h"

namespace snug {
namespace {

constexpr int kStepsOfCorner = 6;
constexpr int kStepsOfEdge = 4;

}  // namespace

Outline rounded_rectangle(double width, double height, double corner_radius) {
    Outline outline;
    for (int corner = 0; corner < 4; ++corner) {
        const double side_a = corner == 0 || corner == 3 ? 1 : -1, side_b = corner < 2 ? 1 : -1;
        for (int step = 0; step <= kStepsOfCorner; ++step) {
            const SineCosine turn = sine_cosine_degrees(90.0 * corner + 90.0 * step / kStepsOfCorner);
            outline.push_back({side_a * (width / 2 - corner_radius) + corner_radius * turn.cosine,
                               side_b * (height / 2 - corner_radius) + corner_radius * turn.sine});
        }
    }
    return outline;
}

void add_block(Mesh& mesh, const Frame& frame, const Block& block) {
    std::vector<Ring> rings;
    const auto add = [&](double inset, double height) {
        const double radius = std::max(block.corner_radius - inset, 0.25);
        Ring ring;
        for (const Point2& p : rounded_rectangle(block.width - 2 * inset, block.height - 2 * inset, radius))
            ring.push_back(frame(p, height));
        rings.push_back(std::move(ring));
    };
    for (int step = 0; step <= 2 * kStepsOfEdge + 1; ++step) {
        const bool lower = step <= kStepsOfEdge;
        const int at = lower ? step : 2 * kStepsOfEdge + 1 - step;
        const SineCosine turn = sine_cosine_degrees(90.0 * at / kStepsOfEdge);
        const double rise = block.edge_radius * (1 - turn.cosine);
        add(block.edge_radius * (1 - turn.sine), lower ? block.low + rise : block.high - rise);
    }
    add_loft(mesh, rings);
}

void add_turned(Mesh& mesh, const Frame& frame, std::span<const ProfilePoint> profile, int sides, Ribs ribs) {
    std::vector<Ring> rings;
    for (const ProfilePoint& p : profile) {
        Ring ring;
        for (int i = 0; i < sides; ++i) {
            const SineCosine turn = sine_cosine_degrees(360.0 * i / sides);
            const bool groove = p.ribbed && ribs.count > 0 && i * ribs.count * 2 / sides % 2 == 1;
            const double radius = p.radius - (groove ? ribs.depth : 0);
            ring.push_back(frame({radius * turn.cosine, radius * turn.sine}, p.height));
        }
        rings.push_back(std::move(ring));
    }
    add_loft(mesh, rings);
}

void add_ring(Mesh& mesh, const Frame& frame, double radius, double thickness_radius, int around,
              int across) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int i = 0; i < around; ++i) {
        const SineCosine turn = sine_cosine_degrees(360.0 * i / around);
        for (int k = 0; k < across; ++k) {
            const SineCosine roll = sine_cosine_degrees(360.0 * k / across);
            const double away = radius + thickness_radius * roll.cosine;
            mesh.vertices.push_back(
                vec_cast<float>(frame({away * turn.cosine, away * turn.sine}, thickness_radius * roll.sine)));
        }
    }
    const auto n = static_cast<std::uint32_t>(across), m = static_cast<std::uint32_t>(around);
    for (std::uint32_t i = 0; i < m; ++i) join_rings(mesh, first + (i + 1) % m * n, first + i * n, n);
}

std::vector<Point2> smooth_curve(std::span<const Point2> points, int steps) {
    std::vector<Point2> curve;
    const std::size_t last = points.size() - 1;
    for (std::size_t i = 0; i < last; ++i) {
        const Point2 p0 = points[i == 0 ? 0 : i - 1], p1 = points[i], p2 = points[i + 1],
                     p3 = points[std::min(i + 2, last)];
        const auto blend = [](double t, double v0, double v1, double v2, double v3) {
            return v1 +
                   0.5 * t * (v2 - v0 + t * (2 * v0 - 5 * v1 + 4 * v2 - v3 + t * (3 * (v1 - v2) + v3 - v0)));
        };
        for (int step = 0; step < steps; ++step) {
            const double t = static_cast<double>(step) / steps;
            curve.push_back({blend(t, p0.a, p1.a, p2.a, p3.a), blend(t, p0.b, p1.b, p2.b, p3.b)});
        }
    }
    curve.push_back(points[last]);
    return curve;
}

void centre(Mesh& mesh) {
    const Vec3d middle = bounds(mesh).centre();
    for (Vec3f& v : mesh.vertices) v = vec_cast<float>(vec_cast<double>(v) - middle);
}

}  // namespace snug
