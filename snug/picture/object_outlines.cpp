#include "snug/picture/object_outlines.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "snug/picture/depth_image.h"

namespace snug {
namespace {

constexpr double kLongestSideCells = 900;
constexpr double kMostCoveredCells = 1 << 28;  // that are drawn, over each other
constexpr int kMarginCells = 3;                // one more than the slope looks aside
constexpr double kLeastCellsWhole = 16;
constexpr double kLeastCellsVisible = 40;  // slivers between the steps of a cavity say nothing
constexpr double kLeastCellsShade = 60;
constexpr double kToleranceCells = 0.4;
constexpr int kSlopeCells = 2;                      // on either side
constexpr Vec3d kLight{-0.45, -0.6, 0.66};          // from the upper left: right, down, towards the viewer
constexpr double kShadeBelow[] = {0.75, 0.5, 0.2};  // of the full light

/// What all triangles cover together, square mm: what it costs to draw them.
double covered_area(std::span<const Projected> vertices, std::span<const Triangle> triangles) {
    double doubled = 0;
    for (const auto& [a, b, c] : triangles) {
        const Vec2d ab = vertices[b].at - vertices[a].at, ac = vertices[c].at - vertices[a].at;
        doubled += std::fabs(ab.x * ac.y - ab.y * ac.x);
    }
    return doubled / 2;
}

/// Coarser where thousands of triangles cover everything.
ImageFrame frame_around(std::span<const Projected> vertices, std::span<const Triangle> triangles,
                        double finest_mm) {
    Vec2d least = vertices.front().at, greatest = least;
    for (const Projected& vertex : vertices) {
        least = {std::min(least.x, vertex.at.x), std::min(least.y, vertex.at.y)};
        greatest = {std::max(greatest.x, vertex.at.x), std::max(greatest.y, vertex.at.y)};
    }
    const Vec2d size = greatest - least;
    ImageFrame frame;
    frame.cell = std::max({finest_mm, std::max(size.x, size.y) / kLongestSideCells,
                           std::sqrt(covered_area(vertices, triangles) / kMostCoveredCells)});
    frame.corner = least - Vec2d{frame.cell, frame.cell} * kMarginCells;
    frame.width = static_cast<int>(size.x / frame.cell) + 1 + 2 * kMarginCells;
    frame.height = static_cast<int>(size.y / frame.cell) + 1 + 2 * kMarginCells;
    return frame;
}

void draw_foam(std::span<const Face> foam, DepthImage& image) {
    for (const Face& face : foam) {
        const Projected a = project(face.origin), b = project(face.origin + face.across),
                        c = project(face.origin + face.across + face.along),
                        d = project(face.origin + face.along);
        image.draw(a, b, c, false);
        image.draw(a, c, d, false);
    }
}

std::vector<Loop> loops_in_mm(const Mask& mask, const ImageFrame& frame, double least_cells) {
    std::vector<Loop> loops;
    for (const Loop& loop : outlines(mask, least_cells)) {
        loops.push_back(simplified(loop, kToleranceCells));
        for (Vec2d& point : loops.back()) point = frame.corner + point * frame.cell;
    }
    return loops;
}

/// How much of the light reaches a covered cell, from the surface's slope about it: 1 towards the light,
/// below 0 away from it. Where the object hides itself the slope is steep, which draws its inner contours.
double lightness(const DepthImage& image, int column, int row) {
    const auto slope = [&](int dx, int dy) {
        const bool after = image.covered(column + dx, row + dy),
                   before = image.covered(column - dx, row - dy);
        const double here = image.nearness(column, row);
        const double rise = (after ? image.nearness(column + dx, row + dy) : here) -
                            (before ? image.nearness(column - dx, row - dy) : here);
        const double run = image.frame().cell * kSlopeCells * ((after ? 1 : 0) + (before ? 1 : 0));
        return run > 0 ? rise / run : 0;
    };
    const Vec3d normal{-slope(kSlopeCells, 0), -slope(0, kSlopeCells), 1};
    return dot(normal, kLight) / std::sqrt(dot(normal, normal) * dot(kLight, kLight));
}

}  // namespace

ObjectOutlines object_outlines(std::span<const Projected> vertices, std::span<const Triangle> triangles,
                               std::span<const Face> foam, double finest_mm) {
    if (vertices.empty() || triangles.empty()) return {};
    const ImageFrame frame = frame_around(vertices, triangles, finest_mm);
    DepthImage object(frame), hiding(frame);
    for (const Triangle& triangle : triangles)
        object.draw(vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]], true);
    draw_foam(foam, hiding);

    Mask whole(frame.width, frame.height), visible = whole;
    std::vector<Mask> shades(std::size(kShadeBelow), whole);
    for (int row = 0; row < frame.height; ++row)
        for (int column = 0; column < frame.width; ++column) {
            if (!object.covered(column, row)) continue;
            whole.set(column, row);
            // A cell's leeway, for an object that lies on the foam is not hidden by it.
            if (object.nearness(column, row) >= hiding.nearness(column, row) - frame.cell) {
                visible.set(column, row);
                const double light = lightness(object, column, row);
                for (std::size_t shade = 0; shade < shades.size(); ++shade)
                    if (light < kShadeBelow[shade]) shades[shade].set(column, row);
            }
        }
    ObjectOutlines result{
        loops_in_mm(whole, frame, kLeastCellsWhole), loops_in_mm(visible, frame, kLeastCellsVisible), {}};
    for (const Mask& shade : shades) result.shades.push_back(loops_in_mm(shade, frame, kLeastCellsShade));
    return result;
}

}  // namespace snug
