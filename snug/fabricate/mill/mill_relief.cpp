#include "snug/fabricate/mill/mill_relief.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "snug/fabricate/mill/mill_allowed.h"
#include "snug/fabricate/mill/relief_loss.h"

namespace snug {
namespace {

constexpr int kPlacesAcross = 10;   // that are tried around a cell, across the cutter
constexpr double kShortWay = 0.75;  // radii: as far as the cutter goes sideways into foam at full depth
constexpr double kInside = 1e-6;    // mm

struct Violation {
    int row, column, allowed;
    double away;  ///< from the nearest cell that is low enough, mm
};

/// Lines of the passes by level, to find the nearest point of them.
class NearestLine {
  public:
    NearestLine(const std::vector<LevelPass>& passes, double reach_mm, Vec2d size_mm) : reach_(reach_mm) {
        columns_ = static_cast<int>(size_mm.x / reach_) + 1;
        rows_ = static_cast<int>(size_mm.y / reach_) + 1;
        for (const LevelPass& pass : passes) {
            Level level{pass.level, std::vector<std::vector<CutLine>>(static_cast<std::size_t>(rows_) *
                                                                      static_cast<std::size_t>(columns_))};
            for (const std::vector<CutLine>* lines : {&pass.fill, &pass.walls})
                for (const CutLine& line : *lines) add(level, line);
            levels_.push_back(std::move(level));
        }
    }

    /// The nearest point within reach at this level.
    [[nodiscard]] std::optional<Vec2d> nearest(Vec2d at, int level) const {
        const auto found = std::find_if(levels_.begin(), levels_.end(),
                                        [level](const Level& each) { return each.level == level; });
        if (found == levels_.end()) return {};
        std::optional<Vec2d> best;
        double least = reach_;
        const int row = cell(at.y, rows_), column = cell(at.x, columns_);
        for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r)
            for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c)
                for (const CutLine& line : found->lines[index(r, c)]) {
                    // Lines of the passes run along an axis.
                    const Vec2d point{
                        std::clamp(at.x, std::min(line.from.x, line.to.x), std::max(line.from.x, line.to.x)),
                        std::clamp(at.y, std::min(line.from.y, line.to.y), std::max(line.from.y, line.to.y))};
                    const double away = length(at - point);
                    if (away >= least) continue;
                    least = away;
                    best = point;
                }
        return best;
    }

  private:
    struct Level {
        int level;
        std::vector<std::vector<CutLine>> lines;
    };

    [[nodiscard]] int cell(double mm, int count) const {
        return std::clamp(static_cast<int>(mm / reach_), 0, count - 1);
    }
    [[nodiscard]] std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }
    void add(Level& level, const CutLine& line) const {
        for (int r = cell(std::min(line.from.y, line.to.y), rows_);
             r <= cell(std::max(line.from.y, line.to.y), rows_); ++r)
            for (int c = cell(std::min(line.from.x, line.to.x), columns_);
                 c <= cell(std::max(line.from.x, line.to.x), columns_); ++c)
                level.lines[index(r, c)].push_back(line);
    }

    double reach_;
    int rows_ = 1, columns_ = 1;
    std::vector<Level> levels_;
};

/// Millimetres from the cell to the nearest that is low enough, at most two radii.
double away_from_low_enough(const CarvedStock& stock, int row, int column, int level, double radius) {
    const Vec2d cell = stock.cell_mm();
    const int rows = static_cast<int>(2 * radius / cell.y), columns = static_cast<int>(2 * radius / cell.x);
    double least = 2 * radius;
    for (int r = std::max(0, row - rows); r <= std::min(stock.height().ny() - 1, row + rows); ++r)
        for (int c = std::max(0, column - columns); c <= std::min(stock.height().nz() - 1, column + columns);
             ++c)
            if (stock.height()(r, c) <= level)
                least = std::min(least, length(Vec2d{(c - column) * cell.x, (r - row) * cell.y}));
    return least;
}

/// Deepest first, and of equally deep ones those that lie farthest within the foam: what reaches them reaches
/// most of the others on its way.
std::vector<Violation> violations(const Grid<int>& allowed, const CarvedStock& stock, double radius) {
    std::vector<Violation> found;
    for (int row = 0; row < allowed.ny(); ++row)
        for (int column = 0; column < allowed.nz(); ++column)
            if (stock.height()(row, column) > allowed(row, column))
                found.push_back({row, column, allowed(row, column),
                                 away_from_low_enough(stock, row, column, allowed(row, column), radius)});
    std::stable_sort(found.begin(), found.end(), [](const Violation& a, const Violation& b) {
        return a.allowed != b.allowed ? a.allowed < b.allowed : a.away > b.away;
    });
    return found;
}

class Reliever {
  public:
    Reliever(const MillField& field, const std::vector<LevelPass>& passes, double radius, CarvedStock& stock)
        : field_(field),
          wanted_(field_heights(field, stock)),
          taken_(wanted_),
          near_(passes, 2 * radius, field.size_mm()),
          radius_(radius),
          stock_(stock) {}

    /// Takes the foam in this cell down to the level.
    void take(const Violation& violation) {
        const Vec2d at = cheapest_place(violation);
        MillRelief relief{at, violation.allowed, near_.nearest(at, violation.allowed)};
        if (relief.from && length(*relief.from - at) > kShortWay * radius_) relief.from.reset();
        const CutLine way{relief.from.value_or(at), at};
        stock_.cut(way, violation.allowed);
        note(way, violation.allowed);
        report_.reliefs.push_back(relief);
    }

    [[nodiscard]] ReliefReport finish() {
        const double volume = stock_.cell_mm().x * stock_.cell_mm().y * field_.step_mm;
        for (std::size_t i = 0; i < wanted_.size(); ++i)
            report_.left_mm3 += std::max(0, stock_.height()[i] - wanted_[i]) * volume;
        const ReliefLoss loss = relief_loss(field_, report_.reliefs, radius_);
        report_.overcut_mm3 = loss.mm3;
        report_.widest_mm = loss.widest_mm;
        return std::move(report_);
    }

  private:
    /// Calls visit(row, column) for the fine cells whose middles lie within the cutter at `at`.
    template <class Visit>
    void for_cells_within(Vec2d at, Visit visit) const {
        const Vec2d cell = stock_.cell_mm();
        const int first = std::max(0, static_cast<int>(std::ceil((at.y - radius_) / cell.y - 0.5)));
        const int last =
            std::min(wanted_.ny() - 1, static_cast<int>(std::floor((at.y + radius_) / cell.y - 0.5)));
        for (int row = first; row <= last; ++row) {
            const double away = (row + 0.5) * cell.y - at.y;
            const double half = std::sqrt(std::max(0.0, radius_ * radius_ - away * away));
            const int from = std::max(0, static_cast<int>(std::ceil((at.x - half) / cell.x - 0.5)));
            const int to =
                std::min(wanted_.nz() - 1, static_cast<int>(std::floor((at.x + half) / cell.x - 0.5)));
            for (int column = from; column <= to; ++column) visit(row, column);
        }
    }

    /// Foam that was to stay and would be lost.
    [[nodiscard]] long long cost(Vec2d at, int level, long long most) const {
        long long lost = 0;
        for_cells_within(at, [&](int row, int column) {
            lost += lost > most ? 0 : std::max(0, taken_(row, column) - level);
        });
        return lost;
    }

    /// All corners of the cell lie within the cutter.
    [[nodiscard]] bool covers(Vec2d at, const Violation& violation) const {
        const Vec2d cell = stock_.cell_mm(), middle = stock_.middle(violation.row, violation.column);
        const Vec2d corner{std::abs(at.x - middle.x) + cell.x / 2, std::abs(at.y - middle.y) + cell.y / 2};
        return length(corner) <= radius_ - kInside;
    }

    [[nodiscard]] Vec2d cheapest_place(const Violation& violation) const {
        const Vec2d middle = stock_.middle(violation.row, violation.column);
        Vec2d best = middle;
        long long least = std::numeric_limits<long long>::max();
        for (int i = -kPlacesAcross / 2; i <= kPlacesAcross / 2; ++i)
            for (int k = -kPlacesAcross / 2; k <= kPlacesAcross / 2; ++k) {
                const Vec2d at = middle + Vec2d{1.0 * k, 1.0 * i} * (2 * radius_ / kPlacesAcross);
                if (!covers(at, violation)) continue;
                const long long lost = cost(at, violation.allowed, least);
                if (lost >= least) continue;
                least = lost;
                best = at;
            }
        return best;
    }

    /// What of the foam that was to stay the cutter takes on this way, so that it costs nothing again.
    void note(const CutLine& way, int level) {
        const int stops = 1 + static_cast<int>(length(way.to - way.from) / (0.1 * radius_));
        for (int stop = 0; stop <= stops; ++stop)
            for_cells_within(way.from + (way.to - way.from) * (1.0 * stop / stops), [&](int row, int column) {
                taken_(row, column) = std::min(taken_(row, column), level);
            });
    }

    const MillField& field_;
    Grid<int> wanted_, taken_;
    NearestLine near_;
    double radius_;
    CarvedStock& stock_;
    ReliefReport report_;
};

}  // namespace

ReliefReport relieve(const MillField& field, const std::vector<LevelPass>& passes, const Grid<int>& allowed,
                     double radius_mm, CarvedStock& stock) {
    Reliever reliever(field, passes, radius_mm, stock);
    for (const Violation& violation : violations(allowed, stock, radius_mm))
        if (stock.height()(violation.row, violation.column) > violation.allowed) reliever.take(violation);
    return reliever.finish();
}

}  // namespace snug
