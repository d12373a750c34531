#include "snug/picture/depth_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace snug {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A double as a cell number, kept within [low, high] whatever its size.
int clamped(double value, int low, int high) {
    return static_cast<int>(std::min(std::max(value, static_cast<double>(low)), static_cast<double>(high)));
}

struct Span {
    double from = kInfinity, to = -kInfinity;
};

/// Where the horizontal line at y meets the edge, added to the span.
void meet(const Projected& p, const Projected& q, double y, Span& span) {
    const double y0 = std::min(p.at.y, q.at.y), y1 = std::max(p.at.y, q.at.y);
    if (y0 == y1 || y < y0 || y > y1) return;
    const double x = p.at.x + (y - p.at.y) * ((q.at.x - p.at.x) / (q.at.y - p.at.y));
    span.from = std::min(span.from, x);
    span.to = std::max(span.to, x);
}

}  // namespace

DepthImage::DepthImage(const ImageFrame& frame)
    : frame_(frame),
      cells_(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height), kNothing) {}

Projected DepthImage::in_cells(const Projected& p) const {
    return {(p.at - frame_.corner) * (1 / frame_.cell), p.nearness};
}

void DepthImage::draw(const Projected& a, const Projected& b, const Projected& c, bool outline) {
    const Projected p = in_cells(a), q = in_cells(b), r = in_cells(c);
    fill(p, q, r);
    if (!outline) return;
    line(p, q);
    line(q, r);
    line(r, p);
}

void DepthImage::fill(const Projected& a, const Projected& b, const Projected& c) {
    const Vec2d ab = b.at - a.at, ac = c.at - a.at;
    const double doubled_area = ab.x * ac.y - ab.y * ac.x;
    if (doubled_area == 0) return;
    const double db = b.nearness - a.nearness, dc = c.nearness - a.nearness;
    const double slope_x = (db * ac.y - dc * ab.y) / doubled_area;
    const double slope_y = (dc * ab.x - db * ac.x) / doubled_area;
    const double least = std::min({a.nearness, b.nearness, c.nearness});
    const double greatest = std::max({a.nearness, b.nearness, c.nearness});

    const int first = clamped(std::ceil(std::min({a.at.y, b.at.y, c.at.y}) - 0.5), 0, frame_.height);
    const int last = clamped(std::floor(std::max({a.at.y, b.at.y, c.at.y}) - 0.5), -1, frame_.height - 1);
    for (int row = first; row <= last; ++row) {
        const double y = row + 0.5;
        Span span;
        meet(a, b, y, span);
        meet(b, c, y, span);
        meet(c, a, y, span);
        const int from = clamped(std::ceil(span.from - 0.5), 0, frame_.width);
        const int to = clamped(std::floor(span.to - 0.5), -1, frame_.width - 1);
        for (int column = from; column <= to; ++column) {
            const double nearness = a.nearness + slope_x * (column + 0.5 - a.at.x) + slope_y * (y - a.at.y);
            double& cell = cells_[index(column, row)];
            // Slivers have steep slopes: rounding must not carry a cell beyond the triangle's own corners.
            cell = std::max(cell, std::min(std::max(nearness, least), greatest));
        }
    }
}

void DepthImage::line(const Projected& a, const Projected& b) {
    const Vec2d way = b.at - a.at;
    const int steps = clamped(std::ceil(std::max(std::fabs(way.x), std::fabs(way.y))), 1,
                              4 * (frame_.width + frame_.height));
    for (int step = 0; step <= steps; ++step) {
        const double share = static_cast<double>(step) / steps;
        const Vec2d at = a.at + way * share;
        if (at.x < 0 || at.y < 0 || at.x >= frame_.width || at.y >= frame_.height) continue;
        double& cell = cells_[index(static_cast<int>(at.x), static_cast<int>(at.y))];
        cell = std::max(cell, a.nearness + (b.nearness - a.nearness) * share);
    }
}

}  // namespace snug
