#include "snug/fabricate/mill/relief_loss.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "snug/fabricate/mill/disc_way.h"

namespace snug {
namespace {

constexpr int kLinesInRadius = 64;

/// Where a line along x enters or leaves what one relief clears down to a level.
struct End {
    double x;
    int level;
    bool enters;
};

class Measure {
  public:
    Measure(const MillField& field, std::span<const MillRelief> reliefs, double radius)
        : field_(field), radius_(radius) {
        lines_a_row_ = std::max(1, static_cast<int>(std::ceil(field.cell_mm.y * kLinesInRadius / radius)));
        spacing_ = field.cell_mm.y / lines_a_row_;
        // Level by level: what lies higher is gathered once for each.
        std::vector<MillRelief> by_level(reliefs.begin(), reliefs.end());
        std::stable_sort(by_level.begin(), by_level.end(),
                         [](const MillRelief& a, const MillRelief& b) { return a.level < b.level; });
        std::optional<CentreLines> lines;
        for (const MillRelief& relief : by_level) {
            if (!lines || lines->level() != relief.level) lines.emplace(field_, relief.level, radius_);
            add(relief, *lines);
        }
        // From near to far, so that a line meets few of them.
        std::stable_sort(ways_.begin(), ways_.end(),
                         [](const Way& a, const Way& b) { return a.low < b.low; });
    }

    [[nodiscard]] ReliefLoss finish() {
        std::size_t next = 0;
        std::vector<Way> here;
        for (long long line = 0;; ++line) {
            if (here.empty()) {
                if (next == ways_.size()) break;
                line = std::max(line, static_cast<long long>(std::floor(ways_[next].low / spacing_)));
            }
            const double y = (static_cast<double>(line) + 0.5) * spacing_;
            for (; next < ways_.size() && ways_[next].low <= y; ++next) here.push_back(ways_[next]);
            here.erase(std::remove_if(here.begin(), here.end(), [y](const Way& way) { return way.high < y; }),
                       here.end());
            measure_line(line, y, here);
        }
        if (!ways_.empty()) loss_.widest_mm += spacing_ / 2;
        return loss_;
    }

  private:
    struct Way {
        CutLine line;
        int level;
        double low, high;
    };

    void add(const MillRelief& relief, const CentreLines& lines) {
        const CutLine line{relief.from.value_or(relief.at), relief.at};
        if (lines.free(line.from, line.to)) return;
        ways_.push_back({line, relief.level, std::min(line.from.y, line.to.y) - radius_,
                         std::max(line.from.y, line.to.y) + radius_});
    }

    void measure_line(long long line, double y, const std::vector<Way>& ways) {
        const long long row = line / lines_a_row_;
        if (row >= field_.height.ny()) return;
        std::vector<End> ends;
        for (const Way& way : ways)
            if (const auto stretch = stretch_of_way(way.line, radius_, y)) {
                ends.push_back({stretch->begin, way.level, true});
                ends.push_back({stretch->end, way.level, false});
            }
        std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.x < b.x; });
        std::multiset<int> levels;
        double from = 0;
        for (const End& end : ends) {
            if (!levels.empty()) measure_piece(static_cast<int>(row), y, {from, end.x}, *levels.begin());
            if (end.enters)
                levels.insert(end.level);
            else if (const auto found = levels.find(end.level); found != levels.end())
                levels.erase(found);
            from = end.x;
        }
    }

    /// A piece of a line that is cleared to one level, column by column.
    void measure_piece(int row, double y, Stretch piece, int level) {
        const double width = field_.cell_mm.x;
        const int first = std::max(0, static_cast<int>(std::floor(piece.begin / width)));
        const int last = std::min(field_.height.nz() - 1, static_cast<int>(std::floor(piece.end / width)));
        for (int column = first; column <= last; ++column) {
            const int lost = field_.height(row, column) - level;
            const double begin = std::max(piece.begin, column * width),
                         end = std::min(piece.end, (column + 1) * width);
            if (lost <= 0 || begin >= end) continue;
            loss_.mm3 += lost * field_.step_mm * (end - begin) * spacing_;
            for (const double x : {begin, (begin + end) / 2, end}) look_at({x, y}, level);
        }
    }

    /// Distances grow no faster than the way between two places: near the last place that was looked at none
    /// can be wider.
    void look_at(Vec2d at, int level) {
        const bool known = level == last_level_ && at.y == last_.y;
        if (known && last_away_ + std::abs(at.x - last_.x) <= loss_.widest_mm) return;
        last_away_ = away_from_pocket(at, level);
        last_ = at;
        last_level_ = level;
        loss_.widest_mm = std::max(loss_.widest_mm, last_away_);
    }

    /// Millimetres to the nearest column that is cut as deep, ring by ring; whatever is no more than the
    /// widest is not looked for any further.
    [[nodiscard]] double away_from_pocket(Vec2d at, int level) const {
        const int row = static_cast<int>(std::floor(at.y / field_.cell_mm.y));
        const int column = static_cast<int>(std::floor(at.x / field_.cell_mm.x));
        const double narrow = std::min(field_.cell_mm.x, field_.cell_mm.y);
        double least = 2 * radius_;
        for (int ring = 0; (ring - 1) * narrow < least; ++ring)
            for (int r = row - ring; r <= row + ring; ++r) {
                const bool whole = std::abs(r - row) == ring;
                for (int c = column - ring; c <= column + ring; c += whole ? 1 : std::max(1, 2 * ring)) {
                    if (!field_.height.contains(r, c) || field_.height(r, c) > level) continue;
                    least = std::min(least, length(Vec2d{outside(at.x, c, field_.cell_mm.x),
                                                         outside(at.y, r, field_.cell_mm.y)}));
                    if (least <= loss_.widest_mm) return least;
                }
            }
        return least;
    }

    static double outside(double value, int cell, double width) {
        return std::max({cell * width - value, value - (cell + 1) * width, 0.0});
    }

    const MillField& field_;
    double radius_;
    int lines_a_row_ = 1;
    double spacing_ = 0;
    std::vector<Way> ways_;
    ReliefLoss loss_;
    Vec2d last_;  ///< where look_at() looked last, and what it found
    int last_level_ = -1;
    double last_away_ = 0;
};

}  // namespace

ReliefLoss relief_loss(const MillField& field, std::span<const MillRelief> reliefs, double radius_mm) {
    return Measure(field, reliefs, radius_mm).finish();
}

}  // namespace snug
