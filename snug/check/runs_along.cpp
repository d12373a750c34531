#include "snug/check/runs_along.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace snug {

RunsAlong::RunsAlong(std::vector<const Grid<Run>*> grids, Vec3i blocks, int axis)
    : grids_(std::move(grids)), axis_(axis), count_(blocks[axis]) {
    if (axis_ > 0) tree_.assign(static_cast<std::size_t>(count_) + 1, 0);
}

void RunsAlong::go_to(int b, int c) {
    if (axis_ == 0) {
        runs_.clear();
        for (const Grid<Run>* grid : grids_)
            if (const Run run = (*grid)(b, c); !run.none()) runs_.push_back(run);
        return;
    }
    const int lane = axis_ == 1 ? b : c, level = axis_ == 1 ? c : b;
    if (lane != lane_) begin_lane(lane);
    for (; next_ < events_.size() && events_[next_].level <= level; ++next_)
        add(events_[next_].position, events_[next_].change);
}

void RunsAlong::begin_lane(int lane) {
    lane_ = lane;
    total_ = 0;
    next_ = 0;
    std::fill(tree_.begin(), tree_.end(), 0);
    events_.clear();
    for (int position = 0; position < count_; ++position)
        for (const Grid<Run>* grid : grids_) {
            const Run run = axis_ == 1 ? (*grid)(position, lane) : (*grid)(lane, position);
            if (run.none()) continue;
            const auto at = static_cast<std::int16_t>(position);
            events_.push_back({run.first, at, 1});
            events_.push_back({run.end, at, -1});
        }
    std::sort(events_.begin(), events_.end(),
              [](const Event& p, const Event& q) { return p.level < q.level; });
}

void RunsAlong::add(int position, int change) {
    total_ += change;
    for (int i = position + 1; i <= count_; i += i & -i) tree_[static_cast<std::size_t>(i)] += change;
}

int RunsAlong::up_to(int block) const {
    int sum = 0;
    if (axis_ == 0) {
        for (const Run run : runs_) sum += std::clamp(block - run.first, 0, run.blocks());
        return sum;
    }
    for (int i = std::clamp(block, 0, count_); i > 0; i -= i & -i) sum += tree_[static_cast<std::size_t>(i)];
    return sum;
}

int RunsAlong::block_with(int before) const {
    int at = 0, step = 1;
    while (2 * step <= count_) step *= 2;
    for (int left = before; step > 0; step /= 2) {
        const int next = at + step;
        if (next > count_ || tree_[static_cast<std::size_t>(next)] > left) continue;
        at = next;
        left -= tree_[static_cast<std::size_t>(next)];
    }
    return at;
}

int RunsAlong::first() const {
    if (axis_ > 0) return block_with(0);
    int first = count_;
    for (const Run run : runs_) first = std::min<int>(first, run.first);
    return first;
}

int RunsAlong::end() const {
    if (axis_ > 0) return total_ == 0 ? 0 : block_with(total_ - 1) + 1;
    int end = 0;
    for (const Run run : runs_) end = std::max<int>(end, run.end);
    return end;
}

}  // namespace snug
