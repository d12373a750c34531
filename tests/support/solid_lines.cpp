#include "tests/support/solid_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace snug::test {

SolidLines::SolidLines(const std::vector<Corners>& triangles, int axis, int count, Vec3d low, Vec3d high)
    : count_(count), crossings_(static_cast<std::size_t>(count) * static_cast<std::size_t>(count)) {
    const int b = (axis + 1) % 3, c = (axis + 2) % 3;
    const double step_b = (high[b] - low[b]) / count, step_c = (high[c] - low[c]) / count;
    // A trifle beside the middles, so that no line runs along an edge of a block.
    const auto place_b = [&](int i) { return low[b] + (i + 0.5003) * step_b; };
    const auto place_c = [&](int k) { return low[c] + (k + 0.4997) * step_c; };
    const auto range = [count](double from, double to, double begin, double step) {
        return std::array{std::max(0, static_cast<int>(std::floor((from - begin) / step)) - 1),
                          std::min(count - 1, static_cast<int>(std::ceil((to - begin) / step)) + 1)};
    };
    for (const Corners& t : triangles) {
        const auto bs = std::minmax({t[0][b], t[1][b], t[2][b]}),
                   cs = std::minmax({t[0][c], t[1][c], t[2][c]});
        const double area =
            (t[1][b] - t[0][b]) * (t[2][c] - t[0][c]) - (t[1][c] - t[0][c]) * (t[2][b] - t[0][b]);
        if (area == 0) continue;
        const auto rows = range(bs.first, bs.second, low[b], step_b),
                   columns = range(cs.first, cs.second, low[c], step_c);
        for (int i = rows[0]; i <= rows[1]; ++i)
            for (int k = columns[0]; k <= columns[1]; ++k) {
                const double u = place_b(i) - t[0][b], v = place_c(k) - t[0][c];
                const double p = (u * (t[2][c] - t[0][c]) - v * (t[2][b] - t[0][b])) / area;
                const double q = (v * (t[1][b] - t[0][b]) - u * (t[1][c] - t[0][c])) / area;
                if (p < 0 || q < 0 || p + q > 1) continue;
                crossings_[static_cast<std::size_t>(i) * static_cast<std::size_t>(count) +
                           static_cast<std::size_t>(k)]
                    .push_back(t[0][axis] + p * (t[1][axis] - t[0][axis]) + q * (t[2][axis] - t[0][axis]));
            }
    }
    for (std::vector<double>& line : crossings_) std::sort(line.begin(), line.end());
}

double SolidLines::inside(int i, int k, double from, double to) const {
    const std::vector<double>& line = at(i, k);
    double sum = 0;
    for (std::size_t n = 0; n + 1 < line.size(); n += 2)
        sum += std::max(0.0, std::min(to, line[n + 1]) - std::max(from, line[n]));
    return sum;
}

}  // namespace snug::test
