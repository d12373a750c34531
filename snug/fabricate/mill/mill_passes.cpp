#include "snug/fabricate/mill/mill_passes.h"

#include <algorithm>
#include <cmath>

namespace snug {
namespace {

/// Of two ascending lists of stretches.
std::vector<Stretch> intersection(const std::vector<Stretch>& a, const std::vector<Stretch>& b) {
    std::vector<Stretch> both;
    std::size_t i = 0, k = 0;
    while (i < a.size() && k < b.size()) {
        const double begin = std::max(a[i].begin, b[k].begin), end = std::min(a[i].end, b[k].end);
        if (begin <= end) both.push_back({begin, end});
        (a[i].end < b[k].end ? i : k)++;
    }
    return both;
}

void add_fill(const CentreLines& lines, double stepover, std::vector<CutLine>& fill) {
    const Vec2d size = lines.field().size_mm();
    const double length = size.y;
    const int count = std::max(1, static_cast<int>(std::ceil(length / stepover)));
    for (int i = 0; i <= count; ++i) {
        const double y = length * i / count;
        for (const Stretch& stretch : intersection({{0, size.x}}, lines.along_x(y)))
            fill.push_back({{stretch.begin, y}, {stretch.end, y}});
    }
}

/// Walls that face one way along one block line, as stretches of the line.
template <class Higher>
std::vector<Stretch> walls_of(int cells, double cell_mm, Higher wall_at) {
    std::vector<Stretch> walls;
    for (int i = 0; i < cells; ++i) {
        if (!wall_at(i)) continue;
        if (!walls.empty() && walls.back().end == i * cell_mm)
            walls.back().end = (i + 1) * cell_mm;
        else
            walls.push_back({i * cell_mm, (i + 1) * cell_mm});
    }
    return walls;
}

/// Beside the stock no filling clears what lies round the ends: the lines go on.
std::vector<Stretch> beside(std::vector<Stretch> walls, double at, double size, double radius) {
    if (at >= 0 && at <= size) return walls;
    for (Stretch& wall : walls) wall = {wall.begin - radius, wall.end + radius};
    return walls;
}

void add_walls(const CentreLines& lines, std::vector<CutLine>& walls) {
    const MillField& field = lines.field();
    const int ny = field.height.ny(), nx = field.height.nz();
    const Vec2d size = field.size_mm();
    const auto higher = [&](int row, int column) { return field.height(row, column) > lines.level(); };
    // side +1: the pocket lies beyond the block line, -1: before it.
    for (const int side : {1, -1}) {
        for (int line = 1; line < ny; ++line) {
            const int foam = side > 0 ? line - 1 : line, pocket = side > 0 ? line : line - 1;
            const double y = line * field.cell_mm.y + side * lines.radius();
            const auto wanted = walls_of(nx, field.cell_mm.x, [&](int column) {
                return higher(foam, column) && !higher(pocket, column);
            });
            if (wanted.empty()) continue;
            for (const Stretch& stretch :
                 intersection(beside(wanted, y, size.y, lines.radius()), lines.along_x(y)))
                walls.push_back({{stretch.begin, y}, {stretch.end, y}});
        }
        for (int line = 1; line < nx; ++line) {
            const int foam = side > 0 ? line - 1 : line, pocket = side > 0 ? line : line - 1;
            const double x = line * field.cell_mm.x + side * lines.radius();
            const auto wanted = walls_of(ny, field.cell_mm.y,
                                         [&](int row) { return higher(row, foam) && !higher(row, pocket); });
            if (wanted.empty()) continue;
            for (const Stretch& stretch :
                 intersection(beside(wanted, x, size.x, lines.radius()), lines.along_y(x)))
                walls.push_back({{x, stretch.begin}, {x, stretch.end}});
        }
    }
}

}  // namespace

LevelPass level_pass(const CentreLines& lines, double stepover_mm) {
    LevelPass pass{lines.level(), {}, {}};
    add_fill(lines, stepover_mm, pass.fill);
    add_walls(lines, pass.walls);
    return pass;
}

std::vector<LevelPass> level_passes(const MillField& field, double radius_mm, double stepover_mm) {
    std::vector<LevelPass> passes;
    for (int level = field.top - 1; level >= field.lowest(); --level) {
        LevelPass pass = level_pass(CentreLines(field, level, radius_mm), stepover_mm);
        if (!pass.empty()) passes.push_back(std::move(pass));
    }
    return passes;
}

double widest_cutter_mm(const MillField& field) {
    if (field.lowest() >= field.top) return 0;
    // What enters any level enters the uppermost.
    double fits = 0, least_that_does_not = 2 * (field.size_mm().x + field.size_mm().y);
    while (least_that_does_not - fits > 1e-4) {
        const double diameter = (fits + least_that_does_not) / 2;
        const LevelPass pass =
            level_pass(CentreLines(field, field.top - 1, diameter / 2), field.cell_mm.y / 4);
        (pass.empty() ? least_that_does_not : fits) = diameter;
    }
    return std::floor(fits * 10 + 0.01) / 10;
}

}  // namespace snug
