#include "snug/check/find_near_items.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "snug/base/grid.h"
#include "snug/base/sliding.h"
#include "snug/base/text.h"

namespace snug {
namespace {

constexpr std::size_t kMostPairs = 20;  // that are told
constexpr double kTouch = 0.01;         // mm that boxes may lie in each other and only touch

/// The rows and columns that an item cuts, and which of them.
struct Footprint {
    int j_first = 0, j_last = -1, k_first = 0, k_last = -1;
    const BlockMap* cut = nullptr;
};

Footprint footprint(const BlockMap& cut) {
    Footprint of{cut.ny(), -1, cut.nz(), -1, &cut};
    for (int j = 0; j < cut.ny(); ++j)
        for (int k = 0; k < cut.nz(); ++k)
            if (!cut(j, k).none()) {
                of.j_first = std::min(of.j_first, j);
                of.j_last = std::max(of.j_last, j);
                of.k_first = std::min(of.k_first, k);
                of.k_last = std::max(of.k_last, k);
            }
    return of;
}

/// A rectangle of columns.
struct Columns {
    int j_first, j_end, k_first, k_end;
    [[nodiscard]] bool none() const { return j_first >= j_end || k_first >= k_end; }
};

/// How far around a column another is less than so many mm away.
struct Reach2d {
    int j, k;
};
Reach2d reach_below(double mm, const DesignSpace& space) {
    const auto reach = [&](double size) { return static_cast<int>(std::ceil(mm / size - 1e-9)); };
    return {reach(space.block_mm.y), reach(space.block_mm.z)};
}

/// The columns of `b`'s that may be so near to one of `a`'s.
Columns near_columns(const Footprint& a, const Footprint& b, Reach2d reach) {
    return {std::max(b.j_first, a.j_first - reach.j), std::min(b.j_last, a.j_last + reach.j) + 1,
            std::max(b.k_first, a.k_first - reach.k), std::min(b.k_last, a.k_last + reach.k) + 1};
}

/// For each of the columns where the highest cut of `a` ends that is no farther than the reach; 0: none is.
Grid<int> highest_end(const Footprint& a, Columns of, Reach2d reach) {
    const auto most = [](int x, int y) { return std::max(x, y); };
    const int height = of.j_end - of.j_first, width = of.k_end - of.k_first;
    Grid<int> along_k(height + 2 * reach.j, width);
    std::vector<int> line;
    for (int row = 0; row < along_k.ny(); ++row) {
        const int j = of.j_first - reach.j + row;
        line.clear();
        for (int k = of.k_first - reach.k; k < of.k_end + reach.k; ++k)
            line.push_back(a.cut->contains(j, k) && !(*a.cut)(j, k).none() ? (*a.cut)(j, k).end : 0);
        slide(line, static_cast<std::size_t>(2 * reach.k + 1), most);
        std::copy(line.begin(), line.end(), &along_k(row, 0));
    }
    Grid<int> highest(height, width);
    for (int column = 0; column < width; ++column) {
        line.clear();
        for (int row = 0; row < along_k.ny(); ++row) line.push_back(along_k(row, column));
        slide(line, static_cast<std::size_t>(2 * reach.j + 1), most);
        for (int row = 0; row < height; ++row) highest(row, column) = line[static_cast<std::size_t>(row)];
    }
    return highest;
}

/// The least number of blocks from what `a` cuts up to what `b` cuts of columns within the reach; may be
/// below 0. None where no column is within it.
std::optional<int> blocks_up(const Footprint& a, const Footprint& b, Reach2d reach) {
    const Columns columns = near_columns(a, b, reach);
    if (columns.none()) return {};
    const Grid<int> highest = highest_end(a, columns, reach);
    std::optional<int> least;
    for (int row = 0; row < highest.ny(); ++row)
        for (int column = 0; column < highest.nz(); ++column) {
            const CutRun cut = (*b.cut)(columns.j_first + row, columns.k_first + column);
            if (cut.none() || highest(row, column) == 0) continue;
            least =
                std::min(least.value_or(cut.first - highest(row, column)), cut.first - highest(row, column));
        }
    return least;
}

/// The least distance, the larger of those along y and z, of what both cut where that is below `wanted`. mm.
std::optional<double> nearer_than(double wanted, const Footprint& a, const Footprint& b,
                                  const DesignSpace& space) {
    if (!blocks_up(a, b, reach_below(wanted, space))) return {};
    std::vector<double> distances{0};  // that there can be
    for (const double size : {space.block_mm.y, space.block_mm.z})
        for (int blocks = 1; blocks * size < wanted - 1e-9; ++blocks) distances.push_back(blocks * size);
    std::sort(distances.begin(), distances.end());
    return *std::partition_point(distances.begin(), distances.end() - 1, [&](double mm) {
        const auto reach = [&](double size) { return static_cast<int>(std::floor(mm / size + 1e-9)) + 1; };
        return !blocks_up(a, b, {reach(space.block_mm.y), reach(space.block_mm.z)});
    });
}

/// By how much the foam along x from `a` up to `b` is thinner than `wanted`, where they are less apart than
/// that along y and z. mm; none where it is not.
std::optional<double> lacking_up(double wanted, const Footprint& a, const Footprint& b,
                                 const DesignSpace& space) {
    const auto blocks = blocks_up(a, b, reach_below(wanted, space));
    if (!blocks || *blocks * space.block_mm.x >= wanted - 1e-9) return {};
    return wanted - *blocks * space.block_mm.x;
}

/// What parts them for sure: along y or z, to either side.
double shift_apart(const Footprint& a, const Footprint& b, const DesignSpace& space, double between_mm) {
    const auto along = [&](int first_a, int last_a, int first_b, int last_b, double size) {
        // A block more, since a shift that is no whole block may cut another column.
        const double foam = (std::ceil(between_mm / size - 1e-9) + 1) * size;
        return std::min(last_a + 1 - first_b, last_b + 1 - first_a) * size + foam;
    };
    return std::min(along(a.j_first, a.j_last, b.j_first, b.j_last, space.block_mm.y),
                    along(a.k_first, a.k_last, b.k_first, b.k_last, space.block_mm.z));
}

bool share_a_column(const Footprint& a, const Footprint& b) {
    for (int j = std::max(a.j_first, b.j_first); j <= std::min(a.j_last, b.j_last); ++j)
        for (int k = std::max(a.k_first, b.k_first); k <= std::min(a.k_last, b.k_last); ++k)
            if (!(*a.cut)(j, k).none() && !(*b.cut)(j, k).none()) return true;
    return false;
}

/// How far two boxes lie in each other along each axis, mm; none where they do not.
std::optional<Vec3d> overlap(const Box3d& a, const Box3d& b) {
    Vec3d size;
    for (int axis = 0; axis < 3; ++axis) {
        size[axis] = std::min(a.max[axis], b.max[axis]) - std::max(a.min[axis], b.min[axis]);
        if (size[axis] <= kTouch) return {};
    }
    return size;
}

void look_for_overlap(const Item& a, const Item& b, std::vector<Finding>& findings) {
    const auto size = overlap(a.placement.bounds, b.placement.bounds);
    if (!size) return;
    findings.push_back(
        {Severity::warning,
         say("items_overlap", {{"one", a.name}, {"other", b.name}, {"size", dimensions(*size)}}),
         (a.placement.bounds.centre() + b.placement.bounds.centre()) * 0.5});
}

Vec3d between(const Item& a, const Item& b) {
    return (a.placement.bounds.centre() + b.placement.bounds.centre()) * 0.5;
}

struct TwoFootprints {
    const Footprint &one, &other;
};

std::optional<Finding> near_in_layer(const Item& a, const Item& b, TwoFootprints of, const DesignSpace& space,
                                     double between_mm) {
    const auto distance = nearer_than(between_mm, of.one, of.other, space);
    if (!distance) return {};
    const bool meet = share_a_column(of.one, of.other);
    const double shift = meet ? shift_apart(of.one, of.other, space, between_mm) : between_mm - *distance;
    return Finding{Severity::danger,
                   say(meet ? "items_near/meet" : "items_near", {{"one", a.name},
                                                                 {"other", b.name},
                                                                 {"distance", number(*distance, 1)},
                                                                 {"between", number(between_mm, 1)},
                                                                 {"shift", number(std::ceil(shift), 0)}}),
                   between(a, b)};
}

/// `b` lies in a layer above that of `a`.
std::optional<Finding> near_above(const Item& a, const Item& b, TwoFootprints of, const DesignSpace& space,
                                  double between_mm) {
    const auto lacking = lacking_up(between_mm, of.one, of.other, space);
    if (!lacking) return {};
    // A block more, since a shift that is no whole block may cut another level.
    const double shift = (std::ceil(*lacking / space.block_mm.x - 1e-9) + 1) * space.block_mm.x;
    return Finding{Severity::danger,
                   say("items_near/layers", {{"one", a.name},
                                             {"other", b.name},
                                             {"distance", number(std::max(0.0, between_mm - *lacking), 1)},
                                             {"between", number(between_mm, 1)},
                                             {"shift", number(std::ceil(shift), 0)}}),
                   between(a, b)};
}

bool may_touch(const Item& a, const Item& b) {
    return !a.group.empty() && a.group == b.group;
}

/// Of each item, what it cuts of the foam below it, of the foam above it, and of either.
class Footprints {
  public:
    explicit Footprints(const std::vector<HalfCuts>& cuts) {
        both_.reserve(cuts.size());  // footprints point at these
        for (const HalfCuts& each : cuts) {
            lower.push_back(footprint(each.lower));
            upper.push_back(each.upper ? footprint(*each.upper) : lower.back());
            if (each.upper) both_.push_back(cut_by_either(each));
            either.push_back(each.upper ? footprint(both_.back()) : lower.back());
        }
    }
    std::vector<Footprint> lower, upper, either;

  private:
    std::vector<BlockMap> both_;
};

}  // namespace

void find_near_items(const std::vector<Item>& items, const std::vector<HalfCuts>& cuts,
                     const DesignSpace& space, double between_mm, std::vector<Finding>& findings) {
    const Footprints footprints(cuts);
    const auto near = [&](std::size_t a, std::size_t b) {
        if (items[a].layer == items[b].layer)
            return near_in_layer(items[a], items[b], {footprints.either[a], footprints.either[b]}, space,
                                 between_mm);
        if (items[a].layer > items[b].layer) std::swap(a, b);
        // The foam between them ends above what the one cuts of it and below what the other does.
        return near_above(items[a], items[b], {footprints.upper[a], footprints.lower[b]}, space, between_mm);
    };
    std::size_t told = 0;
    for (std::size_t a = 0; a < items.size(); ++a)
        for (std::size_t b = a + 1; b < items.size() && told < kMostPairs; ++b) {
            const bool may = may_touch(items[a], items[b]) || between_mm == 0;
            if (may && share_a_column(footprints.either[a], footprints.either[b])) {
                const std::size_t before = findings.size();
                look_for_overlap(items[a], items[b], findings);
                told += findings.size() - before;
            }
            if (may) continue;
            auto finding = near(a, b);
            if (!finding) continue;
            ++told;
            findings.push_back(std::move(*finding));
        }
}

}  // namespace snug
