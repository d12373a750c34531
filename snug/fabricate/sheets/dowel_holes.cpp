#include "snug/fabricate/sheets/dowel_holes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace snug {
namespace {

using Holes = std::vector<Vec2d>;

double nearest(const Holes& holes, Vec2d to) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2d hole : holes) least = std::min(least, length(hole - to));
    return least;
}

/// Counts of cells that all sheets up to one keep, for asking whether a rectangle of cells is whole.
class KeptCounts {
  public:
    KeptCounts(const SheetStack& stack, int sheet)
        : columns_(stack.columns()), rows_(stack.rows()), counts_(rows_ + 1, columns_ + 1, 0) {
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column)
                counts_(row + 1, column + 1) = counts_(row, column + 1) + counts_(row + 1, column) -
                                               counts_(row, column) +
                                               (stack.has(row, column, 0) && stack.has(row, column, sheet));
    }

    [[nodiscard]] bool whole(int first_row, int first_column, int end_row, int end_column) const {
        if (first_row < 0 || first_column < 0 || end_row > rows_ || end_column > columns_) return false;
        return counts_(end_row, end_column) - counts_(first_row, end_column) -
                   counts_(end_row, first_column) + counts_(first_row, first_column) ==
               (end_row - first_row) * (end_column - first_column);
    }

  private:
    int columns_, rows_;
    Grid<int> counts_;
};

/// Middles, corners and side middles of cells around which a square of foam stands.
Holes places(const SheetStack& stack, int sheet, double half_side) {
    const KeptCounts counts(stack, sheet);
    const Vec2d cell = stack.cell_mm;
    Holes found;
    for (int y = 1; y < 2 * stack.rows(); ++y) {
        for (int x = 1; x < 2 * stack.columns(); ++x) {
            const Vec2d at{0.5 * x * cell.x, 0.5 * y * cell.y};
            if (counts.whole(static_cast<int>(std::floor((at.y - half_side) / cell.y)),
                             static_cast<int>(std::floor((at.x - half_side) / cell.x)),
                             static_cast<int>(std::ceil((at.y + half_side) / cell.y)),
                             static_cast<int>(std::ceil((at.x + half_side) / cell.x))))
                found.push_back(at);
        }
    }
    return found;
}

/// The first place with the highest score above 0.
std::optional<Vec2d> best(const Holes& candidates, const std::function<double(Vec2d)>& score) {
    std::optional<Vec2d> found;
    double highest = 0;
    for (const Vec2d at : candidates) {
        const double value = score(at);
        if (value <= highest) continue;
        highest = value;
        found = at;
    }
    return found;
}

/// By how much the triangle's sides differ, and how far it is from flat: 0 where it could be laid on itself
/// turned or mirrored.
double lopsidedness(Vec2d a, Vec2d b, Vec2d c) {
    std::array<double, 3> sides{length(b - a), length(c - b), length(a - c)};
    std::sort(sides.begin(), sides.end());
    const double height =
        std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / std::max(sides[2], 1e-9);
    return std::min({sides[1] - sides[0], sides[2] - sides[1], height});
}

/// As many of the wanted holes as stay apart and tell all ways of laying a sheet apart; none if not two.
Holes chosen(const Holes& candidates, Vec2d rectangle, const SheetOptions& options) {
    const double dowel = options.dowel_mm, apart = 2 * dowel;
    if (candidates.empty()) return {};
    const Vec2d first = candidates.front();
    const auto unlike = [&](Holes holes, Vec2d next) {
        holes.push_back(next);
        return one_way_only(holes, rectangle, dowel);
    };
    const auto second = best(candidates, [&](Vec2d at) {
        return length(at - first) >= apart && (options.dowels > 2 || unlike({first}, at)) ? length(at - first)
                                                                                          : 0.0;
    });
    if (!second) return {};
    Holes holes{first, *second};
    if (options.dowels > 2) {
        const auto third = best(candidates, [&](Vec2d at) {
            const double score = lopsidedness(first, *second, at);
            return score >= dowel && nearest(holes, at) >= apart ? score : 0.0;
        });
        if (third && unlike(holes, *third)) holes.push_back(*third);
    }
    while (holes.size() > 2 && static_cast<int>(holes.size()) < options.dowels) {
        const auto next = best(candidates, [&](Vec2d at) {
            const double distance = nearest(holes, at);
            return distance >= apart && unlike(holes, at) ? distance : 0.0;
        });
        if (!next) break;
        holes.push_back(*next);
    }
    return one_way_only(holes, rectangle, dowel) ? holes : Holes{};
}

}  // namespace

bool one_way_only(const std::vector<Vec2d>& centres, Vec2d rectangle, double least_mm) {
    const double w = rectangle.x, h = rectangle.y;
    const auto differs = [&](const std::function<Vec2d(Vec2d)>& laid) {
        return std::any_of(centres.begin(), centres.end(),
                           [&](Vec2d hole) { return nearest(centres, laid(hole)) >= least_mm; });
    };
    const bool rectangle_ways = differs([&](Vec2d p) {
                                    return Vec2d{w - p.x, h - p.y};
                                }) &&
                                differs([&](Vec2d p) {
                                    return Vec2d{w - p.x, p.y};
                                }) &&
                                differs([&](Vec2d p) {
                                    return Vec2d{p.x, h - p.y};
                                });
    if (!rectangle_ways || std::fabs(w - h) > least_mm) return rectangle_ways;
    return differs([&](Vec2d p) {
               return Vec2d{p.y, p.x};
           }) &&
           differs([&](Vec2d p) {
               return Vec2d{w - p.y, p.x};
           }) &&
           differs([&](Vec2d p) {
               return Vec2d{p.y, h - p.x};
           }) &&
           differs([&](Vec2d p) {
               return Vec2d{w - p.y, h - p.x};
           });
}

DowelHoles dowel_holes(const SheetStack& stack, const SheetOptions& options) {
    if (options.dowels == 0) return {};
    const double half_side = 0.5 * options.dowel_mm + options.dowel_edge_mm;
    // Sheets higher up have less room, so the highest with holes is found by halving.
    DowelHoles found;
    int with = 0, without = stack.count + 1;
    while (without - with > 1) {
        const int sheets = (with + without) / 2;
        Holes holes = chosen(places(stack, sheets - 1, half_side), stack.size_mm(), options);
        if (holes.empty()) {
            without = sheets;
        } else {
            with = sheets;
            found = {std::move(holes), sheets};
        }
    }
    return found;
}

}  // namespace snug
