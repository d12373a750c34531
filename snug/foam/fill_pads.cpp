#include "snug/foam/fill_pads.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>

#include "snug/depth/depth_map.h"
#include "snug/foam/zone_cuts.h"

namespace snug {
namespace {

constexpr double kPadRounding = 1e-6;  // mm
constexpr int kMostSheets = 64;        // that a pad is stacked from

/// What is free in each column between an item and the foam on one side of it, in sheets; 0 where no pad may
/// lie.
struct FreeSheets {
    std::size_t item = 0;
    Piece piece;
    bool above = false;
    Grid<std::int16_t> sheets;
    Grid<std::int16_t> level;  ///< where the foam ends, in blocks
};

/// Rectangle of columns.
struct ColumnRectangle {
    int first_j = 0, end_j = 0, first_k = 0, end_k = 0;
    [[nodiscard]] long long count() const {
        return static_cast<long long>(end_j - first_j) * (end_k - first_k);
    }
};

/// The rectangle of most columns of a level that have `least` at least and that is as wide and long as it
/// must be; of equal ones the first (the largest rectangle under a histogram, row by row).
std::optional<ColumnRectangle> largest(const FreeSheets& free, std::int16_t level, std::int16_t least,
                                       ColumnRectangle smallest) {
    const int nz = free.sheets.nz();
    std::optional<ColumnRectangle> best;
    std::vector<int> height(static_cast<std::size_t>(nz) + 1, 0);
    std::vector<int> open;  // where rectangles begin that may still grow, lower ones first
    for (int j = 0; j < free.sheets.ny(); ++j) {
        open.clear();
        for (int k = 0; k <= nz; ++k) {
            const auto at = static_cast<std::size_t>(k);
            const bool has = k < nz && free.level(j, k) == level && free.sheets(j, k) >= least;
            height[at] = has ? height[at] + 1 : 0;
            while (!open.empty() && height[static_cast<std::size_t>(open.back())] >= height[at]) {
                const int rows = height[static_cast<std::size_t>(open.back())];
                open.pop_back();
                const ColumnRectangle found{j + 1 - rows, j + 1, open.empty() ? 0 : open.back() + 1, k};
                if (rows >= smallest.end_j && k - found.first_k >= smallest.end_k &&
                    (!best || found.count() > best->count()))
                    best = found;
            }
            open.push_back(k);
        }
    }
    return best;
}

struct StackedColumns {
    ColumnRectangle columns;
    std::int16_t sheets = 0;
    [[nodiscard]] long long volume() const { return columns.count() * sheets; }
};

/// The pad of most volume on a level, thicker ones first; none of the least size.
std::optional<StackedColumns> largest_pad(const FreeSheets& free, std::int16_t level,
                                          const DesignSpace& space, std::int16_t least_sheets) {
    std::int16_t most = 0;
    for (std::size_t column = 0; column < free.sheets.size(); ++column)
        if (free.level[column] == level) most = std::max(most, free.sheets[column]);
    const auto columns = [&](int axis) {
        return std::max(1, static_cast<int>(std::ceil(kLeastPadSide / space.block_mm[axis] - kPadRounding)));
    };
    std::optional<StackedColumns> best;
    for (std::int16_t sheets = most; sheets >= least_sheets; --sheets) {
        const auto found = largest(free, level, sheets, {0, columns(1), 0, columns(2)});
        if (found && (!best || found->count() * sheets > best->volume())) best = {*found, sheets};
    }
    return best;
}

/// The largest pad of each level, from which the next is taken.
class LargestPads {
  public:
    LargestPads(FreeSheets& free, const DesignSpace& space, std::int16_t least_sheets)
        : free_(free), space_(space), least_(least_sheets) {
        for (std::size_t column = 0; column < free.sheets.size(); ++column)
            if (free.sheets[column] >= least_) levels_[free.level[column]] = {};
        for (auto& [level, best] : levels_) best = largest_pad(free_, level, space_, least_);
    }
    std::optional<StackedColumns> take() {
        auto found = levels_.end();
        for (auto each = levels_.begin(); each != levels_.end(); ++each)
            if (each->second && (found == levels_.end() || each->second->volume() > found->second->volume()))
                found = each;
        if (found == levels_.end()) return {};
        const StackedColumns pad = *found->second;
        for (int j = pad.columns.first_j; j < pad.columns.end_j; ++j)
            for (int k = pad.columns.first_k; k < pad.columns.end_k; ++k) free_.sheets(j, k) = 0;
        found->second = largest_pad(free_, found->first, space_, least_);
        return pad;
    }

  private:
    FreeSheets& free_;
    const DesignSpace& space_;
    std::int16_t least_;
    std::map<std::int16_t, std::optional<StackedColumns>> levels_;
};

/// Of a pad that so much is free for. Above an item it must end close to it.
std::int16_t sheets_in(double free_mm, bool above, const PadOptions& options) {
    const double count = std::min(std::floor(free_mm / options.sheet_mm + kPadRounding), 1.0 * kMostSheets);
    const double left = free_mm - count * options.sheet_mm;
    if (count * options.sheet_mm < kLeastPad - kPadRounding) return 0;
    if (above && left > kMostLeftAbovePad + options.squeeze_mm + kPadRounding) return 0;
    return static_cast<std::int16_t>(count);
}

/// What an item sees of the columns on one side, and the foam there.
class SeenSide {
  public:
    SeenSide(const ObjectDepths& depths, const DesignSpace& space, bool above, const PadOptions& options)
        : half_(above && depths.upper ? *depths.upper : depths.lower),
          own_(block_map(half_.depths, space, half_.reach)),
          space_(space),
          above_(above),
          options_(options) {}

    /// mm that a pad on this foam may fill; none where the foam does not end at the item's own blocks.
    [[nodiscard]] std::optional<double> free_mm(const Grid<Run>& foam, std::size_t column) const {
        const Run own = own_[column], kept = foam[column];
        if (own.none() || kept.none()) return {};
        if (above_) {
            if (kept.first != own.end) return {};
            return space_.face(0, own.end) - half_.depths[column].highest + options_.squeeze_mm;
        }
        if (kept.end != own.first) return {};
        return half_.depths[column].lowest - half_.reach.mm.x - space_.face(0, own.first);
    }

  private:
    const HalfDepths& half_;
    BlockMap own_;
    const DesignSpace& space_;
    bool above_;
    const PadOptions& options_;
};

/// What is free on both sides of all items.
class FreeSpace {
  public:
    FreeSpace(const std::vector<Item>& items, std::span<const std::shared_ptr<const ObjectDepths>> depths,
              const Foams& foams, const DesignSpace& space, const PadOptions& options)
        : items_(items), depths_(depths), foams_(foams), space_(space), options_(options) {}

    /// Item by item, below it first. `zones`: columns without pads.
    [[nodiscard]] std::vector<FreeSheets> sheets(const Grid<char>& zones) const {
        std::vector<FreeSheets> all;
        for (int layer = 1; layer <= foams_.layers(); ++layer)
            for (const bool above : {false, true})
                if (foams_.has(foams_.at(above ? layer : layer - 1))) add(layer, above, zones, all);
        std::stable_sort(all.begin(), all.end(),
                         [](const FreeSheets& a, const FreeSheets& b) { return a.item < b.item; });
        return all;
    }

  private:
    /// Where several items cut to the same level a pad goes to the one that comes nearest.
    void add(int layer, bool above, const Grid<char>& zones, std::vector<FreeSheets>& all) const {
        const Piece piece = foams_.at(above ? layer : layer - 1);
        const Grid<Run>& foam = foams_.piece(piece);
        Grid<double> nearest(space_.blocks.y, space_.blocks.z, std::numeric_limits<double>::infinity());
        Grid<std::size_t> whose(space_.blocks.y, space_.blocks.z, items_.size());
        const std::size_t before = all.size();
        for (std::size_t i = 0; i < items_.size(); ++i) {
            if (items_[i].layer != layer) continue;
            const SeenSide side(*depths_[i], space_, above, options_);
            for (std::size_t column = 0; column < nearest.size(); ++column) {
                const auto mm = side.free_mm(foam, column);
                if (!mm || zones[column] != 0 || *mm >= nearest[column]) continue;
                nearest[column] = *mm;
                whose[column] = i;
            }
            const Grid<std::int16_t> none(space_.blocks.y, space_.blocks.z, 0);
            all.push_back({i, piece, above, none, none});
        }
        for (std::size_t i = before; i < all.size(); ++i)
            for (std::size_t column = 0; column < nearest.size(); ++column) {
                if (whose[column] != all[i].item) continue;
                all[i].sheets[column] = sheets_in(nearest[column], above, options_);
                all[i].level[column] = above ? foam[column].first : foam[column].end;
            }
    }

    const std::vector<Item>& items_;
    std::span<const std::shared_ptr<const ObjectDepths>> depths_;
    const Foams& foams_;
    const DesignSpace& space_;
    const PadOptions& options_;
};

FillPad pad_of(const FreeSheets& free, const StackedColumns& stacked, const DesignSpace& space,
               double sheet_mm) {
    const ColumnRectangle& at = stacked.columns;
    const double thick = stacked.sheets * sheet_mm;
    const double face = space.face(0, free.level(at.first_j, at.first_k));
    FillPad pad{free.item,  free.piece, free.above,     at.first_j, at.end_j,
                at.first_k, at.end_k,   stacked.sheets, thick,      {}};
    pad.box.min = {free.above ? face - thick : face, space.face(1, at.first_j), space.face(2, at.first_k)};
    pad.box.max = pad.box.min + Vec3d{thick, (at.end_j - at.first_j) * space.block_mm.y,
                                      (at.end_k - at.first_k) * space.block_mm.z};
    return pad;
}

}  // namespace

Result<FillPads> fill_pads(const std::vector<Item>& items,
                           std::span<const std::shared_ptr<const ObjectDepths>> depths, const Foams& foams,
                           const DesignSpace& space, const PadOptions& options) {
    const auto zones = zone_columns(items, space);
    if (!zones) return tl::unexpected(zones.error());
    const auto least =
        static_cast<std::int16_t>(std::max(1.0, std::ceil(kLeastPad / options.sheet_mm - kPadRounding)));
    FillPads all;
    all.squeeze_mm = options.squeeze_mm;
    for (FreeSheets& free : FreeSpace(items, depths, foams, space, options).sheets(*zones)) {
        LargestPads largest(free, space, least);
        std::size_t count = 0;
        while (const auto next = largest.take())
            if (++count <= kMostPads)
                all.pads.push_back(pad_of(free, *next, space, options.sheet_mm));
            else
                ++all.left_out;
    }
    return all;
}

}  // namespace snug
