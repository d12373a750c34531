#include "snug/fabricate/printing/sunk_letters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "snug/polygon/cell_loops.h"
#include "snug/polygon/lattice.h"
#include "snug/polygon/plan_faces.h"
#include "snug/polygon/plan_outline.h"

namespace snug {
namespace {

constexpr int kSquaresInPen = 3;

double distance_squared(Vec2d p, Vec2d a, Vec2d b) {
    const Vec2d way = b - a, to = p - a;
    const double square = way.x * way.x + way.y * way.y, along = to.x * way.x + to.y * way.y;
    const double share = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
    const Vec2d left = to - way * share;
    return left.x * left.x + left.y * left.y;
}

/// Squares in rows and columns, from a corner in steps.
struct Squares {
    PlanPoint corner;
    int side = 1;  // steps
    Mask mask;

    [[nodiscard]] Vec2d middle(int column, int row) const {
        return {in_mm(corner.z + (column + 0.5) * side), in_mm(corner.y + (row + 0.5) * side)};
    }
};

void ink(Squares& squares, Vec2d a, Vec2d b, double radius) {
    const double side = in_mm(squares.side), z = in_mm(squares.corner.z), y = in_mm(squares.corner.y);
    const auto cell = [&](double mm) { return static_cast<int>(std::floor(mm / side)); };
    const int last_column = std::min(squares.mask.width - 1, cell(std::max(a.x, b.x) + radius - z)),
              last_row = std::min(squares.mask.height - 1, cell(std::max(a.y, b.y) + radius - y));
    for (int row = std::max(0, cell(std::min(a.y, b.y) - radius - y)); row <= last_row; ++row)
        for (int column = std::max(0, cell(std::min(a.x, b.x) - radius - z)); column <= last_column; ++column)
            if (distance_squared(squares.middle(column, row), a, b) <= radius * radius)
                squares.mask.set(column, row);
}

/// Squares that meet in a corner alone would make an edge of four walls.
void join_corners(Mask& mask) {
    for (bool changed = true; changed;) {
        changed = false;
        for (int row = 0; row + 1 < mask.height; ++row)
            for (int column = 0; column + 1 < mask.width; ++column) {
                const bool a = mask.contains(column, row), b = mask.contains(column + 1, row),
                           c = mask.contains(column, row + 1), d = mask.contains(column + 1, row + 1);
                if (a != d || b != c || a == b) continue;
                mask.set(a ? column + 1 : column, row);
                changed = true;
            }
    }
}

PlanRegion region_of_squares(const Squares& squares) {
    PlanRegion region;
    for (int row = 0; row < squares.mask.height; ++row) {
        std::vector<PlanSpan> spans;
        for (int column = 0; column < squares.mask.width; ++column) {
            if (!squares.mask.contains(column, row)) continue;
            const int begin = squares.corner.z + column * squares.side, end = begin + squares.side;
            if (!spans.empty() && spans.back().end == begin)
                spans.back().end = end;
            else
                spans.push_back({begin, end});
        }
        const int y = squares.corner.y + row * squares.side;
        if (!spans.empty()) region.append(y, y + squares.side, std::move(spans));
    }
    return region;
}

}  // namespace

PlanRegion inked(std::span<const std::vector<Vec2d>> lines, double pen_mm) {
    Vec2d low{1e9, 1e9}, high{-1e9, -1e9};
    for (const auto& line : lines)
        for (const Vec2d p : line) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
    if (low.x > high.x) return {};
    Squares squares;
    squares.side = std::max(1, static_cast<int>(in_steps(pen_mm / kSquaresInPen)));
    const double radius = pen_mm / 2, side = in_mm(squares.side);
    squares.corner = {static_cast<int>(in_steps(low.y - radius)), static_cast<int>(in_steps(low.x - radius))};
    squares.mask = Mask(static_cast<int>(std::ceil((high.x - low.x + pen_mm) / side)) + 1,
                        static_cast<int>(std::ceil((high.y - low.y + pen_mm) / side)) + 1);
    for (const auto& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i) ink(squares, line[i - 1], line[i], radius);
    join_corners(squares.mask);
    return region_of_squares(squares);
}

PlanBox box_around(const PlanRegion& region, int steps) {
    PlanBox box{{region.bands.front().begin, region.bands.front().spans.front().begin},
                {region.bands.back().end, region.bands.front().spans.front().end}};
    for (const PlanBand& band : region.bands) {
        box.least.z = std::min(box.least.z, band.spans.front().begin);
        box.greatest.z = std::max(box.greatest.z, band.spans.back().end);
    }
    return {{box.least.y - steps, box.least.z - steps}, {box.greatest.y + steps, box.greatest.z + steps}};
}

SunkFaces sunk_faces(const SunkLetters& sunk, std::uint32_t box_vertex, std::uint32_t first_vertex) {
    const std::vector<OutlineCorner> outline = outline_corners(sunk.letters);
    const auto count = static_cast<std::uint32_t>(outline.size());
    SunkFaces faces;
    std::vector<PlanVertex> top{{sunk.box.least, box_vertex},
                                {{sunk.box.least.y, sunk.box.greatest.z}, box_vertex + 1}},
        floor;
    for (std::uint32_t i = 0; i < count; ++i) {
        top.push_back({outline[i].at, first_vertex + i});
        floor.push_back({outline[i].at, first_vertex + count + i});
        faces.points.push_back({outline[i].at, false});
    }
    for (const OutlineCorner& corner : outline) faces.points.push_back({corner.at, true});
    top.push_back({{sunk.box.greatest.y, sunk.box.least.z}, box_vertex + 2});
    top.push_back({sunk.box.greatest, box_vertex + 3});
    triangulate(difference(region_of(sunk.box), sunk.letters), top, 1, faces.triangles);
    triangulate(sunk.letters, floor, 1, faces.triangles);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t from = first_vertex + i, to = first_vertex + outline[i].next;
        faces.triangles.push_back({to + count, from + count, from});
        faces.triangles.push_back({to, to + count, from});
    }
    return faces;
}

}  // namespace snug
