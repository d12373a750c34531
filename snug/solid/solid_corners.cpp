#include "snug/solid/solid_corners.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace snug {
namespace {

/// The blocks around the point, as CornerFanTable takes them. `columns`: in front to the left and right,
/// behind to the left and right.
unsigned blocks_around(const std::array<Run, 4>& columns, int level) {
    unsigned around = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (columns[i].contains(level - 1)) around |= 1u << (2 * i);
        if (columns[i].contains(level)) around |= 2u << (2 * i);
    }
    return around;
}

/// The same along y or along z: no corners.
bool is_straight(const std::array<Run, 4>& columns) {
    return (columns[0] == columns[1] && columns[2] == columns[3]) ||
           (columns[0] == columns[2] && columns[1] == columns[3]);
}

/// Levels at which a run begins or ends, downwards, each once.
class Levels {
  public:
    explicit Levels(const std::array<Run, 4>& columns) {
        for (const Run run : columns) {
            if (run.none()) continue;
            add(run.first);
            add(run.end);
        }
    }
    [[nodiscard]] const int* begin() const { return levels_.data(); }
    [[nodiscard]] const int* end() const { return levels_.data() + count_; }

  private:
    void add(int level) {
        std::size_t at = count_;
        while (at > 0 && levels_[at - 1] < level) --at;
        if (at > 0 && levels_[at - 1] == level) return;
        std::copy_backward(begin() + at, end(), levels_.data() + count_ + 1);
        levels_[at] = level;
        ++count_;
    }

    std::array<int, 8> levels_{};
    std::size_t count_ = 0;
};

/// Finds the corners of one line after another, row by row, and remembers the joined edges (corner_fans.h)
/// that run from line to line.
class LineSweep {
  public:
    void begin_row() {
        along_y_.swap(next_along_y_);
        next_along_y_.clear();
        along_z_.clear();
    }

    /// Downwards, without vertices. They stand until the next line.
    const std::vector<SolidCorner>& next_line(int K, const std::array<Run, 4>& columns) {
        corners_.clear();
        if (is_straight(columns) && along_y_.empty() && along_z_.empty()) return corners_;
        next_along_z_.clear();
        bool upright = false;
        for (const int level : Levels(columns)) {
            const unsigned around = blocks_around(columns, level);
            const unsigned joined = (upright ? 1u : 0u) | (along_y_.count({K, level}) > 0 ? 2u : 0u) |
                                    (along_z_.count(level) > 0 ? 4u : 0u);
            const CornerFans& fans = fans_(around, joined);
            if (fans.count > 0) corners_.push_back({level, 0, &fans});
            upright = (fans.joined & 1) != 0;
            if ((fans.joined & 2) != 0) next_along_y_.insert({K, level});
            if ((fans.joined & 4) != 0) next_along_z_.insert(level);
        }
        along_z_.swap(next_along_z_);
        return corners_;
    }

  private:
    const CornerFanTable& fans_ = CornerFanTable::get();
    std::vector<SolidCorner> corners_;
    std::set<std::pair<int, int>> along_y_, next_along_y_;  ///< by K and level
    std::set<int> along_z_, next_along_z_;                  ///< by level
};

}  // namespace

SolidCorners::SolidCorners(const Grid<Run>& runs) : lines_per_row_(runs.nz() + 1) {
    first_.reserve(static_cast<std::size_t>(runs.ny() + 1) * static_cast<std::size_t>(lines_per_row_) + 1);
    LineSweep sweep;
    for (int J = 0; J <= runs.ny(); ++J) {
        sweep.begin_row();
        for (int K = 0; K <= runs.nz(); ++K) {
            first_.push_back(static_cast<std::uint32_t>(corners_.size()));
            const auto& line = sweep.next_line(K, {run_at(runs, J - 1, K - 1), run_at(runs, J - 1, K),
                                                   run_at(runs, J, K - 1), run_at(runs, J, K)});
            for (auto corner = line.rbegin(); corner != line.rend(); ++corner) {
                corners_.push_back(*corner);
                corners_.back().vertex = static_cast<std::uint32_t>(points_.size());
                points_.insert(points_.end(), corner->fans->count, {corner->level, J, K});
            }
        }
    }
    first_.push_back(static_cast<std::uint32_t>(corners_.size()));
}

std::span<const SolidCorner> SolidCorners::on_line(int J, int K) const {
    const std::size_t line =
        static_cast<std::size_t>(J) * static_cast<std::size_t>(lines_per_row_) + static_cast<std::size_t>(K);
    return std::span(corners_).subspan(first_[line], first_[line + 1] - first_[line]);
}

}  // namespace snug
