#include "snug/check/find_near_items.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

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

/// Between two cells of a row, mm.
double apart(int a, int b, double size) {
    return std::max(0, std::abs(a - b) - 1) * size;
}

/// The least distance of what both cut where it is below `wanted`.
std::optional<double> nearer_than(double wanted, const Footprint& a, const Footprint& b,
                                  const DesignSpace& space) {
    const double y = space.block_mm.y, z = space.block_mm.z;
    const int reach_j = static_cast<int>(std::ceil(wanted / y - 1e-9));
    const int reach_k = static_cast<int>(std::ceil(wanted / z - 1e-9));
    double least = wanted;
    bool found = false;
    const auto look = [&](int j, int k) {
        for (int i = std::max(b.j_first, j - reach_j); i <= std::min(b.j_last, j + reach_j); ++i)
            for (int l = std::max(b.k_first, k - reach_k); l <= std::min(b.k_last, k + reach_k); ++l) {
                const double distance = std::max(apart(i, j, y), apart(l, k, z));
                if (distance >= wanted - 1e-9 || (*b.cut)(i, l).none()) continue;
                least = std::min(least, distance);
                found = true;
            }
    };
    for (int j = std::max(a.j_first, b.j_first - reach_j); j <= std::min(a.j_last, b.j_last + reach_j); ++j)
        for (int k = std::max(a.k_first, b.k_first - reach_k); k <= std::min(a.k_last, b.k_last + reach_k);
             ++k)
            if (least > 0 && !(*a.cut)(j, k).none()) look(j, k);
    return found ? std::optional<double>(least) : std::nullopt;
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

bool may_touch(const Item& a, const Item& b) {
    return !a.group.empty() && a.group == b.group;
}

}  // namespace

void find_near_items(const std::vector<Item>& items, const std::vector<BlockMap>& cut,
                     const DesignSpace& space, double between_mm, std::vector<Finding>& findings) {
    std::vector<Footprint> footprints;
    for (const BlockMap& each : cut) footprints.push_back(footprint(each));
    std::size_t told = 0;
    for (std::size_t a = 0; a < items.size(); ++a)
        for (std::size_t b = a + 1; b < items.size() && told < kMostPairs; ++b) {
            const bool may = may_touch(items[a], items[b]) || between_mm == 0;
            if (may && share_a_column(footprints[a], footprints[b])) {
                const std::size_t before = findings.size();
                look_for_overlap(items[a], items[b], findings);
                told += findings.size() - before;
            }
            if (may) continue;
            const auto distance = nearer_than(between_mm, footprints[a], footprints[b], space);
            if (!distance) continue;
            ++told;
            const bool meet = share_a_column(footprints[a], footprints[b]);
            const double shift =
                meet ? shift_apart(footprints[a], footprints[b], space, between_mm) : between_mm - *distance;
            findings.push_back(
                {Severity::danger,
                 say(meet ? "items_near/meet" : "items_near", {{"one", items[a].name},
                                                               {"other", items[b].name},
                                                               {"distance", number(*distance, 1)},
                                                               {"between", number(between_mm, 1)},
                                                               {"shift", number(std::ceil(shift), 0)}}),
                 (items[a].placement.bounds.centre() + items[b].placement.bounds.centre()) * 0.5});
        }
}

}  // namespace snug
