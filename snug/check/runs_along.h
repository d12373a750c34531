#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "snug/base/grid.h"
#include "snug/base/run.h"
#include "snug/base/vec.h"

namespace snug {

/// Which blocks of some runs along x lie on a line along any axis. Across x it goes through the ends of runs,
/// from line to line, and never through blocks.
class RunsAlong {
  public:
    /// `grids`: of one space of so many blocks, no block in two of them; they must outlive this.
    RunsAlong(std::vector<const Grid<Run>*> grids, Vec3i blocks, int axis);

    /// The axes that a line is named by, and whether lines are to be visited by the second of them first.
    [[nodiscard]] static int across(int axis, int which) { return (axis + 1 + which) % 3; }

    /// To the line through the blocks b and c along across(axis, 0) and across(axis, 1). Within a lane (along
    /// y: b, along z: c) levels must not fall; a new lane may be any.
    void go_to(int b, int c);

    /// How many of the blocks first..end-1 of the line there are.
    [[nodiscard]] int count(int first, int end) const { return up_to(end) - up_to(first); }
    [[nodiscard]] bool has(int block) const { return count(block, block + 1) > 0; }
    /// The lowest, and behind the highest; first() >= end() where there are none.
    [[nodiscard]] int first() const;
    [[nodiscard]] int end() const;

  private:
    struct Event {
        std::int16_t level, position, change;
    };
    void begin_lane(int lane);
    void add(int position, int change);
    /// How many there are below a block.
    [[nodiscard]] int up_to(int block) const;
    /// The block that has `before` of them below it.
    [[nodiscard]] int block_with(int before) const;

    std::vector<const Grid<Run>*> grids_;
    int axis_, count_;
    std::vector<Run> runs_;  ///< along x: of the line
    // Across x: a Fenwick tree over the line.
    int lane_ = -1, total_ = 0;
    std::size_t next_ = 0;
    std::vector<Event> events_;
    std::vector<std::int32_t> tree_;
};

}  // namespace snug
