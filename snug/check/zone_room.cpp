#include "snug/check/zone_room.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "snug/base/axes.h"
#include "snug/check/runs_along.h"
#include "snug/depth/object_depths.h"

namespace snug {
namespace {

constexpr double kTouchingZone = 1e-6;  // mm

DesignSpace along(const DesignSpace& space, int axis) {
    return {with_first(space.blocks, axis), with_first(space.block_mm, axis)};
}

Placement along(const Placement& placement, int axis) {
    Placement turned;
    for (int i = 0; i < 3; ++i)
        turned.rotation.row[static_cast<std::size_t>(i)] =
            placement.rotation.row[static_cast<std::size_t>((axis + i) % 3)];
    turned.shift = with_first(placement.shift, axis);
    turned.bounds = {with_first(placement.bounds.min, axis), with_first(placement.bounds.max, axis)};
    return turned;
}

std::vector<const Grid<Run>*> grids_of(const Foams& foams) {
    std::vector<const Grid<Run>*> grids;
    for (const Piece piece : foams.all()) grids.push_back(&foams.piece(piece));
    return grids;
}

/// What lies on a line of blocks, by its faces in mm from the space's middle.
class BlockLine {
  public:
    BlockLine(const Packing& packing, const DesignSpace& space, int axis)
        : space_(space),
          foam_(grids_of(*packing.foams), packing.space.blocks, axis),
          available_({&packing.available}, packing.space.blocks, axis) {}

    void go_to(int b, int c) {
        foam_.go_to(b, c);
        available_.go_to(b, c);
    }

    /// Where the way down from `mm` ends.
    [[nodiscard]] double end_below(double mm) const {
        int block = static_cast<int>(std::floor(blocks_to(mm) + kTouchingZone));
        block = std::min(block, available_.end());
        while (block > available_.first() && !foam_.has(block - 1)) --block;
        return space_.face(0, std::max(block, available_.first()));
    }
    /// The same upwards.
    [[nodiscard]] double end_above(double mm) const {
        int block = static_cast<int>(std::ceil(blocks_to(mm) - kTouchingZone));
        block = std::max(block, available_.first());
        while (block < available_.end() && !foam_.has(block)) ++block;
        return space_.face(0, std::min(block, available_.end()));
    }

  private:
    [[nodiscard]] double blocks_to(double mm) const { return (mm - space_.face(0, 0)) / space_.block_mm.x; }

    const DesignSpace& space_;
    RunsAlong foam_, available_;
};

/// In the order in which RunsAlong visits lines.
template <class Visit>
void for_each_line(const DesignSpace& space, int axis, Visit visit) {
    const int lanes = axis == 2 ? space.blocks.z : space.blocks.y;
    const int levels = axis == 2 ? space.blocks.y : space.blocks.z;
    for (int lane = 0; lane < lanes; ++lane)
        for (int level = 0; level < levels; ++level) axis == 2 ? visit(level, lane) : visit(lane, level);
}

}  // namespace

Result<std::array<double, 6>> zone_room_mm(const ItemZone& zone, const Item& item, const Packing& packing,
                                           const Progress& progress) {
    std::array<double, 6> room;
    room.fill(std::numeric_limits<double>::infinity());
    CutOptions beside;
    beside.clearance_mm = {{0, kZoneRoom, kZoneRoom}, {0, kZoneRoom, kZoneRoom}};
    for (int axis = 0; axis < 3; ++axis) {
        const DesignSpace space = along(packing.space, axis);
        const auto seen = object_depths(*zone.surface, along(item.placement, axis), space, beside,
                                        part_of(progress, axis / 3.0, (axis + 1) / 3.0));
        if (!seen) return tl::unexpected(seen.error());
        BlockLine line(packing, space, axis);
        double& low = room[static_cast<std::size_t>(2 * axis)];
        double& high = room[static_cast<std::size_t>(2 * axis + 1)];
        for_each_line(space, axis, [&](int b, int c) {
            const DepthRange depth = seen->lower.depths(b, c);
            if (depth.none()) return;
            line.go_to(b, c);
            low = std::min(low, std::max(0.0, depth.lowest - line.end_below(depth.lowest)));
            if (axis != 0 || !packing.foams->open())
                high = std::min(high, std::max(0.0, line.end_above(depth.highest) - depth.highest));
        });
    }
    return room;
}

}  // namespace snug
