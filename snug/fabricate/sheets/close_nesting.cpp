#include "snug/fabricate/sheets/close_nesting.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "snug/search/mask_sheets.h"

namespace snug {
namespace {

constexpr long long kNestingWork = 6'000'000;  // of each colour
constexpr int kMostSteps = 6;                  // of the lattice along a cell's side
constexpr int kMostAcross = 600;               // along the stock's side
constexpr std::size_t kMostNested = 400;       // every two are looked at
constexpr double kStepRounding = 1e-6;         // mm

/// The lattice along one axis: a cell's side is so many steps, and so many of them keep cuts apart.
struct Steps {
    int of_cell = 1, of_gap = 0;
    double mm = 1;
};

/// The coarsest lattice that wastes little of the gap.
Steps steps_for(double cell_mm, double gap_mm, double room_mm) {
    Steps best;
    double least = 0;
    for (int n = 1; n <= kMostSteps; ++n) {
        const double step = cell_mm / n;
        if (n > 1 && room_mm / step > kMostAcross) break;
        const int gap = static_cast<int>(std::ceil(gap_mm / step - 1e-9));
        const double waste = gap * step - gap_mm + 0.02 * n * cell_mm;
        if (n == 1 || waste < least - kStepRounding) {
            best = {n, gap, step};
            least = waste;
        }
    }
    return best;
}

BitMask in_steps_of(const Mask& mask, int down, int across) {
    BitMask fine(mask.height * down, mask.width * across);
    for (int row = 0; row < fine.rows(); ++row)
        for (int column = 0; column < fine.columns(); ++column)
            if (mask.contains(column / across, row / down)) fine.set(row, column);
    return fine;
}

class CloseNester {
  public:
    CloseNester(std::span<const PieceToNest> pieces, Vec2d cell, const SheetOptions& options,
                const Nesting& known)
        : pieces_(pieces),
          cell_(cell),
          known_(known),
          border_(options.margin_mm + options.kerf_mm),
          gap_(options.spacing_mm + options.kerf_mm),
          down_(steps_for(cell.y, gap_, known.stock_mm.y)),
          across_(steps_for(cell.x, gap_, known.stock_mm.x)),
          nesting_(known) {}

    std::optional<Nesting> nest() {
        nesting_.stocks = 0;
        nesting_.used_mm2 = 0;
        bool better = false;
        for (const int color : {0, 1}) {
            better = nest_color(color) || better;
            if (color == 0) nesting_.first_color_stocks = nesting_.stocks;
        }
        if (!better) return {};
        find_hosts();
        return nesting_;
    }

  private:
    [[nodiscard]] double end_of(std::size_t piece, Vec2d corner) const {
        return corner.y + pieces_[piece].mask->height * cell_.y;
    }

    /// What the known nesting has of a colour: its stocks from the first on, and how far each is used.
    struct Known {
        int first = 0;
        std::vector<double> ends;
    };
    [[nodiscard]] Known known_of(int color) const {
        Known known;
        known.first = color == 0 ? 0 : known_.first_color_stocks;
        const int end = color == 0 ? known_.first_color_stocks : known_.stocks;
        known.ends.assign(static_cast<std::size_t>(end - known.first), 0);
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (pieces_[i].color != color) continue;
            double& far = known.ends[static_cast<std::size_t>(known_.places[i].stock - known.first)];
            far = std::max(far, end_of(i, known_.places[i].corner));
        }
        return known;
    }

    static double sum_of(const std::vector<double>& ends) {
        double sum = 0;
        for (const double end : ends) sum += end;
        return sum;
    }

    /// True where it found better than what is known; else that is taken over.
    bool nest_color(int color) {
        const Known known = known_of(color);
        std::vector<std::size_t> which;
        for (std::size_t i = 0; i < pieces_.size(); ++i)
            if (pieces_[i].color == color) which.push_back(i);
        std::vector<double> ends;
        const auto packed = pack(which, known);
        if (packed)
            for (const int rows : packed->rows) ends.push_back(border_ + rows * down_.mm);
        const bool better =
            packed &&
            (ends.size() < known.ends.size() ||
             (ends.size() == known.ends.size() && sum_of(ends) < sum_of(known.ends) - kStepRounding));
        for (std::size_t i = 0; i < which.size(); ++i) {
            PiecePlace& place = nesting_.places[which[i]];
            if (better) {
                const LaidMask& at = packed->layout[i];
                place = {at.bin, {border_ + at.column * across_.mm, border_ + at.row * down_.mm}, -1};
            } else {
                place.stock -= known.first;
            }
            place.stock += nesting_.stocks;
        }
        for (const double end : better ? ends : known.ends)
            nesting_.used_mm2 += nesting_.stock_mm.x * (end + border_);
        nesting_.stocks += static_cast<int>(better ? ends.size() : known.ends.size());
        return better;
    }

    [[nodiscard]] std::optional<PackedSheets> pack(const std::vector<std::size_t>& which,
                                                   const Known& known) const {
        if (which.empty() || which.size() > kMostNested) return {};
        const auto steps = [](double mm, double step) {
            return static_cast<int>(std::floor(mm / step + kStepRounding));
        };
        SheetTask task;
        // No sheet needs to be used farther than one is now.
        const double far = std::min(known_.stock_mm.y - border_,
                                    known.ends.size() > 1 ? known_.stock_mm.y : known.ends.front());
        task.rows = steps(far - border_, down_.mm);
        task.columns = steps(known_.stock_mm.x - 2 * border_, across_.mm);
        task.most_sheets = static_cast<int>(known.ends.size());
        task.work = kNestingWork;
        if (std::max(task.rows, task.columns) > 2 * kMostAcross) return {};
        MaskProblem problem;
        problem.gap = {down_.of_gap, across_.of_gap};
        std::map<std::pair<int, std::vector<char>>, int> shapes;
        for (const std::size_t i : which) {
            const Mask& mask = *pieces_[i].mask;
            const auto [shape, fresh] =
                shapes.try_emplace({mask.width, mask.cells}, static_cast<int>(problem.shapes.size()));
            if (fresh) problem.shapes.push_back({in_steps_of(mask, down_.of_cell, across_.of_cell)});
            problem.pieces.push_back({{shape->second}, {}, -1, -1});
        }
        return fewest_sheets(problem, task);
    }

    /// The smallest piece within whose bounding box another lies.
    void find_hosts() {
        const auto box = [&](std::size_t i) {
            const Vec2d corner = nesting_.places[i].corner;
            return std::pair(
                corner, corner + Vec2d{pieces_[i].mask->width * cell_.x, pieces_[i].mask->height * cell_.y});
        };
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            int& host = nesting_.places[i].host;
            host = -1;
            double least = 0;
            const auto [from, to] = box(i);
            for (std::size_t k = 0; k < pieces_.size(); ++k) {
                if (k == i || nesting_.places[k].stock != nesting_.places[i].stock) continue;
                const auto [low, high] = box(k);
                const double area = (high.x - low.x) * (high.y - low.y);
                const bool inside = low.x <= from.x && low.y <= from.y && to.x <= high.x && to.y <= high.y &&
                                    area > (to.x - from.x) * (to.y - from.y);
                if (!inside || (host >= 0 && area >= least)) continue;
                host = static_cast<int>(k);
                least = area;
            }
        }
    }

    std::span<const PieceToNest> pieces_;
    Vec2d cell_;
    const Nesting& known_;
    double border_, gap_;
    Steps down_, across_;
    Nesting nesting_;
};

}  // namespace

std::optional<Nesting> closer_nesting(std::span<const PieceToNest> pieces, Vec2d cell_mm,
                                      const SheetOptions& options, const Nesting& known) {
    return CloseNester(pieces, cell_mm, options, known).nest();
}

}  // namespace snug
