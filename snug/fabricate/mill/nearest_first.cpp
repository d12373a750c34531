#include "snug/fabricate/mill/nearest_first.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace snug {
namespace {

/// Ends of lines in square cells.
class EndFinder {
  public:
    struct End {
        std::size_t line;
        bool last;  ///< the line's second end
        Vec2d at;
    };

    EndFinder(const std::vector<CutLine>& lines, double reach, bool both_ends) : done_(lines.size(), 0) {
        for (const CutLine& line : lines)
            for (const Vec2d end : {line.from, line.to}) {
                low_ = {std::min(low_.x, end.x), std::min(low_.y, end.y)};
                high_ = {std::max(high_.x, end.x), std::max(high_.y, end.y)};
            }
        // About one line a cell, but none smaller than a fraction of the reach.
        const double area = std::max(1e-9, (high_.x - low_.x) * (high_.y - low_.y));
        side_ = std::max(
            {reach / 4, std::sqrt(area / static_cast<double>(std::max<std::size_t>(1, lines.size()))), 1e-3});
        columns_ = static_cast<int>((high_.x - low_.x) / side_) + 1;
        rows_ = static_cast<int>((high_.y - low_.y) / side_) + 1;
        cells_.resize(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_));
        for (std::size_t i = 0; i < lines.size(); ++i) {
            add({i, false, lines[i].from});
            if (both_ends) add({i, true, lines[i].to});
        }
    }

    /// The nearest end of a line that was not taken; takes it.
    [[nodiscard]] End take_nearest(Vec2d at) {
        const int row = clamped((at.y - low_.y) / side_, rows_),
                  column = clamped((at.x - low_.x) / side_, columns_);
        const End* best = nullptr;
        double least = std::numeric_limits<double>::infinity();
        for (int ring = 0; ring <= std::max(rows_, columns_); ++ring) {
            // Cells of this ring are at least so far away.
            if (best && (ring - 1) * side_ > least) break;
            look_in_ring(row, column, ring, at, best, least);
        }
        const End end = *best;
        done_[end.line] = 1;
        return end;
    }

  private:
    [[nodiscard]] static int clamped(double value, int count) {
        return std::clamp(static_cast<int>(std::floor(value)), 0, count - 1);
    }
    [[nodiscard]] std::vector<End>& cell(int row, int column) {
        return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                      static_cast<std::size_t>(column)];
    }
    void add(const End& end) {
        cell(clamped((end.at.y - low_.y) / side_, rows_), clamped((end.at.x - low_.x) / side_, columns_))
            .push_back(end);
    }

    void look_in_ring(int row, int column, int ring, Vec2d at, const End*& best, double& least) {
        for (int r = std::max(0, row - ring); r <= std::min(rows_ - 1, row + ring); ++r) {
            const bool whole = r == row - ring || r == row + ring;
            const int step = whole || ring == 0 ? 1 : 2 * ring;
            for (int c = column - ring; c <= column + ring; c += step)
                if (c >= 0 && c < columns_) look_in(r, c, at, best, least);
        }
    }

    void look_in(int row, int column, Vec2d at, const End*& best, double& least) {
        std::vector<End>& ends = cell(row, column);
        ends.erase(
            std::remove_if(ends.begin(), ends.end(), [&](const End& end) { return done_[end.line] != 0; }),
            ends.end());
        for (const End& end : ends) {
            const double away = length(end.at - at);
            const bool first = best && away == least && (end.line < best->line);
            if (away > least || (away == least && best && !first)) continue;
            least = away;
            best = &end;
        }
    }

    std::vector<char> done_;
    Vec2d low_{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Vec2d high_{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    double side_ = 1;
    int rows_ = 1, columns_ = 1;
    std::vector<std::vector<End>> cells_;
};

}  // namespace

std::vector<CutLine> nearest_first(const std::vector<CutLine>& lines, Vec2d start, double reach_mm) {
    std::vector<CutLine> ordered;
    if (lines.empty()) return ordered;
    EndFinder finder(lines, reach_mm, true);
    Vec2d at = start;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const EndFinder::End end = finder.take_nearest(at);
        const CutLine& line = lines[end.line];
        ordered.push_back(end.last ? CutLine{line.to, line.from} : line);
        at = ordered.back().to;
    }
    return ordered;
}

std::vector<std::size_t> nearest_first_order(const std::vector<CutLine>& lines, Vec2d start,
                                             double reach_mm) {
    std::vector<std::size_t> order;
    if (lines.empty()) return order;
    EndFinder finder(lines, reach_mm, false);
    Vec2d at = start;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const EndFinder::End end = finder.take_nearest(at);
        order.push_back(end.line);
        at = lines[end.line].from;
    }
    return order;
}

}  // namespace snug
