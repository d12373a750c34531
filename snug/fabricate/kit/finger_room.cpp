#include "snug/fabricate/kit/finger_room.h"

#include <algorithm>

#include "snug/depth/depth_map.h"

namespace snug {
namespace {

constexpr double kWantedCell = 2;  // mm
constexpr int kMostCells = 512;    // along an axis
constexpr int kMostCellsABlock = 16;

int cells_a_block(double block_mm, int blocks) {
    const int wanted = static_cast<int>(block_mm / kWantedCell);
    return std::clamp(wanted, 1, std::clamp(kMostCells / blocks, 1, kMostCellsABlock));
}

/// What a finger that comes from above meets in each fine cell.
enum class Ground : char { foam, room, object };

Grid<Ground> ground(const Mesh& mesh, const Placement& placement, const DesignSpace& space,
                    const DesignSpace& fine, const BlockMap& blocks, const Grid<Run>& below, int parting) {
    const DepthMap object = depth_map(mesh, placement, fine, Reach{});
    const int per_y = fine.blocks.y / space.blocks.y, per_z = fine.blocks.z / space.blocks.z;
    const double deepest = space.face(0, parting) - kFingerDepth;
    Grid<Ground> grid(fine.blocks.y, fine.blocks.z, Ground::foam);
    for (int j = 0; j < grid.ny(); ++j)
        for (int k = 0; k < grid.nz(); ++k) {
            const int lower = below(j / per_y, k / per_z).end;
            const bool open = !blocks(j / per_y, k / per_z).none() && space.face(0, lower) <= deepest + 1e-9;
            grid(j, k) = !object(j, k).none() ? Ground::object : open ? Ground::room : Ground::foam;
        }
    return grid;
}

/// The widest way from foam to object along one line, and the cell in its middle. The first along the line.
struct Way {
    int cells = 0;
    int middle = 0;
};
template <class At>
Way widest_way(int length, At at) {
    Way widest;
    for (int i = 0; i < length;) {
        if (at(i) != Ground::room) {
            ++i;
            continue;
        }
        int end = i;
        while (end < length && at(end) == Ground::room) ++end;
        // Only the way to the object's outer side counts, not what lies behind it.
        if (end < length && at(end) == Ground::object) return {end - i, (i + end) / 2};
        i = end;
    }
    return widest;
}

FingerRoom room_on_side(const Grid<Ground>& grid, const DesignSpace& fine, double parting_x, bool along_y,
                        bool from_end) {
    const int lines = along_y ? grid.nz() : grid.ny(), length = along_y ? grid.ny() : grid.nz();
    const int axis = along_y ? 1 : 2;
    FingerRoom best;
    for (int line = 0; line < lines; ++line) {
        const auto index = [&](int i) { return from_end ? length - 1 - i : i; };
        const Way way =
            widest_way(length, [&](int i) { return along_y ? grid(index(i), line) : grid(line, index(i)); });
        const double mm = way.cells * fine.block_mm[axis];
        if (mm <= best.mm) continue;
        const double at = fine.face(axis, index(way.middle));
        const double beside = fine.face(along_y ? 2 : 1, line);
        best = {mm, along_y ? Vec3d{parting_x, at, beside} : Vec3d{parting_x, beside, at}};
    }
    return best;
}

}  // namespace

std::array<FingerRoom, 4> finger_room(const Mesh& mesh, const Placement& placement, const DesignSpace& space,
                                      const BlockMap& blocks, const Grid<Run>& below, int parting) {
    const int per_y = cells_a_block(space.block_mm.y, space.blocks.y);
    const int per_z = cells_a_block(space.block_mm.z, space.blocks.z);
    const DesignSpace fine{{space.blocks.x, space.blocks.y * per_y, space.blocks.z * per_z},
                           {space.block_mm.x, space.block_mm.y / per_y, space.block_mm.z / per_z}};
    const Grid<Ground> grid = ground(mesh, placement, space, fine, blocks, below, parting);
    const double parting_x = space.face(0, parting);
    return {room_on_side(grid, fine, parting_x, true, false), room_on_side(grid, fine, parting_x, true, true),
            room_on_side(grid, fine, parting_x, false, false),
            room_on_side(grid, fine, parting_x, false, true)};
}

}  // namespace snug
