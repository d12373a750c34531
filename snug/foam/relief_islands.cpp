#include "snug/foam/relief_islands.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "snug/base/text.h"
#include "snug/polygon/convex_hull.h"
#include "snug/polygon/polygon.h"

namespace snug {
namespace {

constexpr double kRoundingOfRelief = 1e-6;  // mm

/// Columns of the item's pocket that lie far enough from its rim.
Grid<char> inside_rim(const BlockMap& own, const DesignSpace& space) {
    const auto beside = [&](int axis) {
        return static_cast<int>(std::ceil(kBesideIsland / space.block_mm[axis] - kRoundingOfRelief));
    };
    const int rows = beside(1), columns = beside(2);
    Grid<char> inside(own.ny(), own.nz(), 1);
    for (int j = 0; j < own.ny(); ++j)
        for (int k = 0; k < own.nz(); ++k) {
            const bool at_edge = j == 0 || k == 0 || j + 1 == own.ny() || k + 1 == own.nz();
            if (!own(j, k).none() && !at_edge) continue;
            for (int y = std::max(0, j - rows); y <= std::min(own.ny() - 1, j + rows); ++y)
                for (int z = std::max(0, k - columns); z <= std::min(own.nz() - 1, k + columns); ++z)
                    inside(y, z) = 0;
        }
    return inside;
}

/// Counts columns that may carry, in any rectangle of them.
class CarryingColumns {
  public:
    CarryingColumns(const BlockMap& layer, const RelievedItem& item, const DesignSpace& space)
        : sums_(layer.ny() + 1, layer.nz() + 1, 0), first_(space.blocks.x) {
        const Grid<char> inside = inside_rim(item.own, space);
        const auto bears = [&](int j, int k) {
            const CutRun own = item.own(j, k);
            return !own.none() && inside(j, k) != 0 && item.zones(j, k) == 0 &&
                   layer(j, k).first == own.first && own.first > item.under(j, k);
        };
        for (int j = 0; j < layer.ny(); ++j)
            for (int k = 0; k < layer.nz(); ++k)
                if (bears(j, k)) {
                    first_ = std::min<int>(first_, item.own(j, k).first);
                    under_ = std::max(under_, item.under(j, k));
                }
        const int highest = first_ + static_cast<int>(kCarryingDepth / space.block_mm.x + kRoundingOfRelief);
        for (int j = 0; j < layer.ny(); ++j)
            for (int k = 0; k < layer.nz(); ++k)
                sums_(j + 1, k + 1) = sums_(j, k + 1) + sums_(j + 1, k) - sums_(j, k) +
                                      (bears(j, k) && item.own(j, k).first <= highest ? 1 : 0);
    }
    [[nodiscard]] bool any() const { return sums_[sums_.size() - 1] > 0; }
    [[nodiscard]] bool all(const ReliefIsland& in) const {
        const int count = sums_(in.end_j, in.end_k) - sums_(in.first_j, in.end_k) -
                          sums_(in.end_j, in.first_k) + sums_(in.first_j, in.first_k);
        return count == (in.end_j - in.first_j) * (in.end_k - in.first_k);
    }
    /// Of the foam below the lowest of them, in blocks.
    [[nodiscard]] int depth() const { return first_ - under_; }

  private:
    Grid<int> sums_;
    int first_, under_ = 0;
};

Vec2d middle_of(const ReliefIsland& island, const DesignSpace& space) {
    return {(space.face(1, island.first_j) + space.face(1, island.end_j)) / 2,
            (space.face(2, island.first_k) + space.face(2, island.end_k)) / 2};
}

bool overlap(const ReliefIsland& a, const ReliefIsland& b) {
    return a.first_j < b.end_j && b.first_j < a.end_j && a.first_k < b.end_k && b.first_k < a.end_k;
}

/// The farthest from the centre towards each corner, of those that do not meet the ones before.
std::vector<ReliefIsland> towards_corners(const CarryingColumns& carrying, const DesignSpace& space,
                                          Vec2d centre, int rows, int columns) {
    std::vector<ReliefIsland> islands;
    for (const Vec2d corner : {Vec2d{-1, -1}, Vec2d{1, 1}, Vec2d{-1, 1}, Vec2d{1, -1}}) {
        std::optional<ReliefIsland> best;
        double farthest = 0;
        for (int j = 0; j + rows <= space.blocks.y; ++j)
            for (int k = 0; k + columns <= space.blocks.z; ++k) {
                const ReliefIsland island{j, j + rows, k, k + columns};
                const Vec2d off = middle_of(island, space) - centre;
                const Vec2d towards{off.x * corner.x, off.y * corner.y};
                if (towards.x <= 0 || towards.y <= 0) continue;
                // Both ways count alike, however long the item is.
                const double far = towards.x * towards.y;
                if (far <= farthest || !carrying.all(island)) continue;
                if (std::any_of(islands.begin(), islands.end(),
                                [&](const ReliefIsland& other) { return overlap(island, other); }))
                    continue;
                farthest = far;
                best = island;
            }
        if (best) islands.push_back(*best);
    }
    return islands;
}

/// Whether three stand apart from one line with the centre between them.
bool carry(const std::vector<ReliefIsland>& islands, const DesignSpace& space, Vec2d centre) {
    if (islands.size() < 3) return false;
    std::vector<Vec2d> middles;
    for (const ReliefIsland& island : islands) middles.push_back(middle_of(island, space));
    const std::vector<Vec2d> hull = convex_hull(std::move(middles));
    return hull.size() >= 3 && contains(hull, centre);
}

}  // namespace

FloorRelief relief_islands(const BlockMap& layer, const RelievedItem& item, const DesignSpace& space,
                           const ReliefOptions& options) {
    FloorRelief relief;
    relief.blocks =
        std::max(1, static_cast<int>(std::floor(options.height_mm / space.block_mm.x + kRoundingOfRelief)));
    const double height = relief.blocks * space.block_mm.x;
    const double least = std::max(kBucklingShare * height, item.rib_mm);
    if (options.island_mm < least - kRoundingOfRelief) {
        relief.why_not = say("no_relief/slender", {{"height_mm", number(height, 1)},
                                                   {"island_mm", number(options.island_mm, 1)},
                                                   {"least_mm", number(std::ceil(least), 0)}});
        return relief;
    }
    const CarryingColumns carrying(layer, item, space);
    if (!carrying.any()) {
        relief.why_not = say("no_relief/nothing");
        return relief;
    }
    relief.foam_mm = carrying.depth() * space.block_mm.x;
    const int most = carrying.depth() - 1;
    const int fewest = static_cast<int>(std::ceil(kLeastReliefShare * carrying.depth() - kRoundingOfRelief));
    if (fewest > most) {
        relief.why_not = say("no_relief/thin", {{"foam_mm", number(relief.foam_mm, 1)}});
        return relief;
    }
    if (relief.blocks < fewest || relief.blocks > most) {
        relief.why_not = say("no_relief/depth", {{"height_mm", number(options.height_mm, 1)},
                                                 {"foam_mm", number(relief.foam_mm, 1)},
                                                 {"least_mm", number(fewest * space.block_mm.x, 1)},
                                                 {"most_mm", number(most * space.block_mm.x, 1)}});
        return relief;
    }
    const auto blocks = [&](int axis) {
        return static_cast<int>(std::ceil(options.island_mm / space.block_mm[axis] - kRoundingOfRelief));
    };
    relief.islands = towards_corners(carrying, space, item.centre, blocks(1), blocks(2));
    if (!carry(relief.islands, space, item.centre)) {
        relief.islands.clear();
        relief.why_not = say("no_relief/room", {{"island_mm", number(options.island_mm, 1)}});
    }
    return relief;
}

void cut_relief(BlockMap& layer, const RelievedItem& item, FloorRelief& relief) {
    for (int j = 0; j < layer.ny(); ++j)
        for (int k = 0; k < layer.nz(); ++k) {
            const CutRun own = item.own(j, k);
            CutRun& cut = layer(j, k);
            if (own.none() || cut.none() || cut.first < own.first) continue;
            if (std::any_of(relief.islands.begin(), relief.islands.end(),
                            [&](const ReliefIsland& island) { return island.has(j, k); }))
                continue;
            // A block at least stays on the case.
            const int first = std::max(own.first - relief.blocks, item.under(j, k) + 1);
            if (first >= cut.first) continue;
            relief.cut_blocks += cut.first - first;
            cut.first = static_cast<std::int16_t>(first);
        }
}

}  // namespace snug
