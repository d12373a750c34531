#include "snug/search/item_ways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>

#include "snug/base/parallel.h"
#include "snug/foam/object_cut.h"
#include "snug/search/extreme_points.h"
#include "snug/search/frames.h"
#include "snug/search/searched_zones.h"
#include "snug/search/turn.h"
#include "snug/space/place_object.h"

namespace snug {
namespace {

constexpr int kLevels = 8;                   // offsets within a block along x
constexpr double kUncut = 0.0101;            // mm that a room may reach into blocks without cutting them
constexpr std::uint64_t kSpreadTurns = 400;  // of all rotations, looked at by their boxes
constexpr std::size_t kFreeTurns = 16;       // of these, laid on the blocks

/// Blocks around the middle that hold the item wherever it lies within a block of the middle.
DesignSpace space_around(const Box3d& grown_box, Vec3d block_mm) {
    DesignSpace space{{}, block_mm};
    for (int axis = 0; axis < 3; ++axis) {
        const double half = std::max(grown_box.max[axis], -grown_box.min[axis]);
        space.blocks[axis] = 2 * (static_cast<int>(std::ceil(half / block_mm[axis])) + 2);
    }
    return space;
}

/// What an item and its zones see of their columns; the item first.
using SeenDepths = std::vector<ObjectDepths>;

SeenDepths seen_by(const PreparedSurface& surface, const Item& item, const DesignSpace& space) {
    SeenDepths seen{object_depths(surface, item.placement, space, item.cut)};
    for (const ItemZone& zone : item.zones)  // of meshes it never fails
        if (auto depths = object_depths(*zone.surface, item.placement, space, zone.own_cut(item.cut)))
            seen.push_back(std::move(*depths));
    return seen;
}

bool reached(const SeenDepths& seen, int j, int k) {
    return std::any_of(seen.begin(), seen.end(), [&](const ObjectDepths& depths) {
        return !depths.lower.depths(j, k).none() || (depths.upper && !depths.upper->depths(j, k).none());
    });
}

/// As pack() cuts them, by either half.
BlockMap cut_by(const SeenDepths& seen, const DesignSpace& space) {
    HalfCuts all = half_cuts(seen.front(), space);
    for (std::size_t i = 1; i < seen.size(); ++i) {
        const HalfCuts own = half_cuts(seen[i], space);
        all = united(std::array<const HalfCuts*, 2>{&all, &own});
    }
    return cut_by_either(all);
}

/// What is reached and cut, from its first level, row and column, which `first` is told; none where nothing
/// is. Columns count that the surface reaches, and blocks that the item's room does: squeezed it may cut none
/// of them, as its level has it, and must not leave the space.
std::optional<ItemWay> trimmed(const SeenDepths& seen, const DesignSpace& space, const Box3d& room,
                               Vec3i& first) {
    const BlockMap cut = cut_by(seen, space);
    Vec3i low{1 << 30, 1 << 30, 1 << 30}, high{-1, -1, -1};
    for (int j = 0; j < cut.ny(); ++j)
        for (int k = 0; k < cut.nz(); ++k) {
            if (!reached(seen, j, k)) continue;
            low = {low.x, std::min(low.y, j), std::min(low.z, k)};
            high = {high.x, std::max(high.y, j), std::max(high.z, k)};
            const CutRun run = cut(j, k);
            if (run.none()) continue;
            low.x = std::min<int>(low.x, run.first);
            high.x = std::max<int>(high.x, run.end);
        }
    if (high.x < 0) return {};
    for (int axis = 0; axis < 3; ++axis) {
        const double block = space.block_mm[axis], begin = space.face(axis, 0);
        const auto lowest = static_cast<int>(std::floor((room.min[axis] + kUncut - begin) / block));
        const auto end = static_cast<int>(std::ceil((room.max[axis] - kUncut - begin) / block));
        low[axis] = std::min(low[axis], lowest);
        high[axis] = std::max(high[axis], axis == 0 ? end : end - 1);
    }
    ItemWay way;
    way.mask = BitMask(high.y - low.y + 1, high.z - low.z + 1);
    way.cut = Grid<Run>(way.mask.rows(), way.mask.columns());
    way.height = high.x - low.x;
    way.halves_differ = seen.front().upper.has_value();
    for (int j = std::max(0, -low.y); j < std::min(way.mask.rows(), cut.ny() - low.y); ++j)
        for (int k = std::max(0, -low.z); k < std::min(way.mask.columns(), cut.nz() - low.z); ++k) {
            if (reached(seen, low.y + j, low.z + k)) way.mask.set(j, k);
            const CutRun run = cut(low.y + j, low.z + k);
            if (run.none()) continue;
            way.cut(j, k) = {static_cast<std::int16_t>(run.first - low.x),
                             static_cast<std::int16_t>(run.end - low.x)};
            way.cut_blocks += run.blocks();
        }
    first = low;
    return way;
}

Vec3d corner(const DesignSpace& space, Vec3i at) {
    return {space.face(0, at.x), space.face(1, at.y), space.face(2, at.z)};
}

void raise(HalfDepths& half, double mm) {
    for (DepthRange& range : half.depths) range = {range.lowest + mm, range.highest + mm};
}

/// Of the levels within a block the one that needs the least height, and cuts least.
std::optional<ItemWay> at_best_level(const PreparedSurface& surface, const Item& item, Vec3d offset,
                                     const DesignSpace& space) {
    const SeenDepths seen = seen_by(surface, item, space);
    std::optional<ItemWay> best;
    for (int level = 0; level < kLevels; ++level) {
        const double mm = space.block_mm.x * level / kLevels;
        SeenDepths raised = seen;
        for (ObjectDepths& depths : raised) {
            raise(depths.lower, mm);
            if (depths.upper) raise(*depths.upper, mm);
        }
        Vec3i first;
        Box3d room = room_of(item);
        room.min.x += mm;
        room.max.x += mm;
        auto way = trimmed(raised, space, room, first);
        if (!way) continue;
        way->offset_mm = offset + Vec3d{mm, 0, 0} - corner(space, first);
        if (!best || std::tuple(way->height, way->cut_blocks) < std::tuple(best->height, best->cut_blocks))
            best = std::move(way);
    }
    return best;
}

/// Of one rotation, in every place of a lattice within a block, whose first lays the box by a block's face.
std::vector<ItemWay> laid_everywhere(const PreparedSurface& surface, const Item& middle, Vec3d block_mm,
                                     int places) {
    const Box3d room = room_of(middle);
    const DesignSpace space = space_around(room, block_mm);
    Vec3d flush;  // shifts the room's corner to the next corner of a block
    for (int axis = 0; axis < 3; ++axis)
        flush[axis] = std::ceil(room.min[axis] / block_mm[axis]) * block_mm[axis] - room.min[axis];
    std::vector<std::optional<ItemWay>> found(static_cast<std::size_t>(places) *
                                              static_cast<std::size_t>(places));
    parallel_for(found.size(), [&](std::size_t i) {
        const int place = static_cast<int>(i);
        const Vec3d offset =
            flush + Vec3d{0, block_mm.y * (place / places) / places, block_mm.z * (place % places) / places};
        Item item = middle;
        move(item, offset);
        found[i] = at_best_level(surface, item, offset, space);
    });
    std::vector<ItemWay> ways;
    for (auto& way : found)
        if (way) ways.push_back(std::move(*way));
    return ways;
}

/// What cuts fewest columns and then blocks first; of what is as wide and as high one way alone, and none
/// that is wider both ways without cutting less.
std::vector<ItemWay> the_few_best(std::vector<ItemWay> ways) {
    std::stable_sort(ways.begin(), ways.end(), [](const ItemWay& a, const ItemWay& b) {
        return std::tuple(a.height, a.mask.count(), a.cut_blocks) <
               std::tuple(b.height, b.mask.count(), b.cut_blocks);
    });
    std::vector<ItemWay> best;
    for (ItemWay& way : ways) {
        const bool no_better = std::any_of(best.begin(), best.end(), [&](const ItemWay& other) {
            return other.mask.rows() <= way.mask.rows() && other.mask.columns() <= way.mask.columns() &&
                   other.mask.count() <= way.mask.count();
        });
        if (!no_better) best.push_back(std::move(way));
    }
    return best;
}

void add_quarter_turns(const Turn& given, bool all_ways, std::vector<Turn>& turns) {
    const std::array<Turn, 6>& lays = turns_onto_faces();
    for (std::size_t lay = 0; lay < (all_ways ? lays.size() : 1); ++lay)
        for (int quarter = 0; quarter < 4; ++quarter)
            turns.push_back(turn_about({1, 0, 0}, 90 * quarter) * lays[lay] * given);
}

/// Of rotations spread over all those whose box is smallest.
void add_free_turns(const Object& object, const AllowedTurns& allowed, std::uint64_t seed,
                    std::vector<Turn>& turns) {
    const ExtremePoints points(object.mesh);
    std::vector<Turn> spread = suggested_turns(object.mesh);
    for (std::uint64_t i = 0; i < kSpreadTurns; ++i) spread.push_back(allowed.spread(i, seed));
    std::vector<std::pair<double, std::size_t>> by_volume;
    for (std::size_t i = 0; i < spread.size(); ++i) {
        const Vec3d lengths = points.lengths(rotation_of(spread[i]));
        if (allowed.allows(spread[i])) by_volume.emplace_back(lengths.x * lengths.y * lengths.z, i);
    }
    std::sort(by_volume.begin(), by_volume.end());
    for (std::size_t i = 0; i < std::min(kFreeTurns, by_volume.size()); ++i)
        turns.push_back(spread[by_volume[i].second]);
}

}  // namespace

std::vector<Vec3d> allowed_rotations(const Object& object, Vec3d given_deg, const SearchOptions& options) {
    const AllowedTurns allowed(options.upright);
    Turn given = turn_of(rotation_from_euler(given_deg));
    std::vector<Vec3d> rotations;
    if (allowed.allows(given))
        rotations.push_back(given_deg);
    else
        given = allowed.plain();
    std::vector<Turn> turns;
    if (options.turns == Turns::none)
        turns.push_back(given);
    else
        add_quarter_turns(given, options.turns != Turns::upright, turns);
    if (options.turns == Turns::any) add_free_turns(object, allowed, options.seed, turns);
    std::vector<Turn> taken;
    if (!rotations.empty()) taken.push_back(given);
    for (const Turn& turn : turns) {
        const bool known = std::any_of(taken.begin(), taken.end(),
                                       [&](const Turn& other) { return closeness(turn, other) > 1 - 1e-9; });
        if (known || !allowed.allows(turn)) continue;
        taken.push_back(turn);
        rotations.push_back(euler_of(rotation_of(turn)));
    }
    return rotations;
}

Result<std::vector<ItemWay>> ways_to_lay(const Object& object, const CutOptions& cut, Vec3d block_mm,
                                         const std::vector<Vec3d>& rotations_deg, int places,
                                         std::size_t most, const std::vector<ItemZone>& zones) {
    std::vector<std::vector<ItemWay>> of_each;
    for (const Vec3d rotation : rotations_deg) {
        const auto placement = place(object, rotation, {});
        if (!placement) return tl::unexpected(placement.error());
        const Item middle = lying(*placement, cut, zones);
        of_each.push_back(the_few_best(laid_everywhere(*object.prepared, middle, block_mm, places)));
        for (ItemWay& way : of_each.back()) way.rotation_deg = rotation;
    }
    // The best of each rotation first, then the second of each.
    std::vector<ItemWay> ways;
    for (std::size_t rank = 0, before = 1; before != ways.size() || rank == 0; ++rank) {
        before = ways.size();
        for (auto& own : of_each)
            if (rank < own.size() && ways.size() < most) ways.push_back(std::move(own[rank]));
    }
    return ways;
}

Result<LockedWay> locked_way(const Object& object, const CutOptions& cut, const DesignSpace& space,
                             Vec3d rotation_deg, Vec3d offset_mm, const std::vector<ItemZone>& zones) {
    const auto placement = place(object, rotation_deg, offset_mm);
    if (!placement) return tl::unexpected(placement.error());
    LockedWay locked;
    const Item item = lying(*placement, cut, zones);
    auto way = trimmed(seen_by(*object.prepared, item, space), space, room_of(item), locked.first);
    if (way) locked.way = std::move(*way);
    locked.way.rotation_deg = rotation_deg;
    locked.way.offset_mm = offset_mm - corner(space, locked.first);
    return locked;
}

}  // namespace snug
