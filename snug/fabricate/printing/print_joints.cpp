#include "snug/fabricate/printing/print_joints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "snug/base/box.h"

namespace snug {
namespace {

constexpr double kLeastWall = 2;         // mm of foam around a bore
constexpr double kBlockRounding = 1e-8;  // mm
constexpr int kMostSamples = 48;         // of places along each side of a cut
constexpr std::size_t kMostBores = 4;    // for two parts

using Pair = std::pair<int, int>;

/// Places from `low` to `high`, both included, no nearer than `step` and no more than kMostSamples.
std::vector<double> samples(double low, double high, double step) {
    if (high < low) return {};
    const int count = std::min(static_cast<int>(std::min((high - low) / step, 1e6)), kMostSamples - 1);
    std::vector<double> places;
    for (int i = 0; i <= count; ++i)
        places.push_back(count == 0 ? (low + high) / 2 : low + (high - low) * i / count);
    return places;
}

class JointPlacer {
  public:
    JointPlacer(const PrintLayout& layout, const BlockLines& block_lines, const PrintOptions& options)
        : layout_(layout),
          block_lines_(block_lines),
          reach_(bore_corner_radius_mm(options) + kLeastWall),
          depth_(bore_depth_mm(options) + kLeastWall),
          step_(options.dowel_diameter_mm / 2),
          spacing_(4 * options.dowel_diameter_mm),
          taken_(layout.parts.size()) {}

    Joints place() {
        for (int axis = 1; axis <= 3; ++axis) {
            const int across = axis % 3;  // upright cuts first: they carry more
            for (int piece = 1; piece < layout_.cuts.pieces(across); ++piece) place_across(across, piece);
        }
        return std::move(joints_);
    }

  private:
    [[nodiscard]] const std::vector<int>& lines(int axis) const {
        return layout_.cuts.lines[static_cast<std::size_t>(axis)];
    }
    [[nodiscard]] double line_mm(int axis, int line) const {
        return block_lines_[static_cast<std::size_t>(axis)]
                           [static_cast<std::size_t>(lines(axis)[static_cast<std::size_t>(line)])];
    }

    /// The block between two lines that a place lies in, from its first line onward; a line within `rounding`
    /// of the place counts as being there.
    [[nodiscard]] int block_at(int axis, double place, double rounding = 0) const {
        const auto& all = block_lines_[static_cast<std::size_t>(axis)];
        return static_cast<int>(std::upper_bound(all.begin(), all.end(), place + rounding) - all.begin()) - 1;
    }

    /// Every cut between pieces `piece` - 1 and `piece` along an axis.
    void place_across(int axis, int piece) {
        const auto [row_axis, position_axis] = plane_axes(axis);
        for (int row = 0; row < layout_.cuts.pieces(row_axis); ++row)
            for (int position = 0; position < layout_.cuts.pieces(position_axis); ++position) {
                Vec3i after;
                after[axis] = piece;
                after[row_axis] = row;
                after[position_axis] = position;
                place_between(axis, after);
            }
    }

    void place_between(int axis, Vec3i after) {
        std::map<Pair, std::vector<Vec3d>> places;
        Vec3i before = after;
        --before[axis];
        for (const Pair& pair : meeting_parts(axis, before, after)) places[pair] = {};
        const auto [row_axis, position_axis] = plane_axes(axis);
        Vec3d centre;
        centre[axis] = line_mm(axis, after[axis]);
        const auto along = [&](int a) {
            return samples(line_mm(a, after[a]) + reach_, line_mm(a, after[a] + 1) - reach_, step_);
        };
        const std::vector<double> positions = along(position_axis);
        for (const double row : along(row_axis)) {
            centre[row_axis] = row;
            for (const double position : positions) {
                centre[position_axis] = position;
                const Pair pair{part_at(before, centre), part_at(after, centre)};
                if (pair.first >= 0 && pair.second >= 0 && fits(pair, axis, centre))
                    places[pair].push_back(centre);
            }
        }
        for (auto& [pair, found] : places) choose(axis, after, pair, found);
    }

    /// The levels of the half that a part fills in a column of its piece.
    [[nodiscard]] Run levels_of(int index, Vec3i piece, int j, int k) const {
        const PrintPart& part = layout_.parts[static_cast<std::size_t>(index)];
        const Run run = part.runs(lines(1)[static_cast<std::size_t>(piece.y)] + j - part.first.y,
                                  lines(2)[static_cast<std::size_t>(piece.z)] + k - part.first.z);
        return {static_cast<std::int16_t>(run.first + part.first.x),
                static_cast<std::int16_t>(run.end + part.first.x)};
    }

    /// Pairs of parts that share a block's face at the cut.
    [[nodiscard]] std::vector<Pair> meeting_parts(int axis, Vec3i before, Vec3i after) const {
        const Grid<int>& a = part_grid(before);
        const Grid<int>& b = part_grid(after);
        std::vector<Pair> pairs;
        const auto add = [&](int j, int k, int j2, int k2) {
            const int first = a(j, k), second = b(j2, k2);
            if (first < 0 || second < 0) return;
            const Run one = levels_of(first, before, j, k), other = levels_of(second, after, j2, k2);
            if (axis == 0 ? one.end != other.first : !one.meets(other)) return;
            if (pairs.empty() || pairs.back() != Pair{first, second}) pairs.push_back({first, second});
        };
        if (axis == 1)
            for (int k = 0; k < a.nz(); ++k) add(a.ny() - 1, k, 0, k);
        else if (axis == 2)
            for (int j = 0; j < a.ny(); ++j) add(j, a.nz() - 1, j, 0);
        else
            for (int j = 0; j < a.ny(); ++j)
                for (int k = 0; k < a.nz(); ++k) add(j, k, j, k);
        return pairs;
    }

    [[nodiscard]] const Grid<int>& part_grid(Vec3i piece) const {
        return layout_.part_at[static_cast<std::size_t>(layout_.tile(piece.x, piece.y, piece.z))];
    }

    [[nodiscard]] int part_at(Vec3i piece, Vec3d at) const {
        const Grid<int>& parts = part_grid(piece);
        const auto column = [&](int axis, int count) {
            const int first = lines(axis)[static_cast<std::size_t>(piece[axis])];
            return std::clamp(block_at(axis, at[axis]) - first, 0, count - 1);
        };
        return parts(column(1, parts.ny()), column(2, parts.nz()));
    }

    /// The room that a bore and the foam around it take in one of the parts.
    [[nodiscard]] Box3d room(int axis, Vec3d centre, bool after) const {
        Box3d box{centre, centre};
        for (int a = 0; a < 3; ++a) {
            box.min[a] -= a != axis ? reach_ : after ? 0 : depth_;
            box.max[a] += a != axis ? reach_ : after ? depth_ : 0;
        }
        return box;
    }

    [[nodiscard]] bool fits(Pair pair, int axis, Vec3d centre) const {
        return has_room(pair.first, room(axis, centre, false)) &&
               has_room(pair.second, room(axis, centre, true));
    }

    /// Whether the box is all foam of this part and takes no other bore's room.
    [[nodiscard]] bool has_room(int index, const Box3d& box) const {
        const PrintPart& part = layout_.parts[static_cast<std::size_t>(index)];
        const auto first = [&](int a) { return block_at(a, box.min[a], kBlockRounding) - part.first[a]; };
        const auto end = [&](int a) { return block_at(a, box.max[a], -kBlockRounding) + 1 - part.first[a]; };
        // No dowels in parts whose floor is no plane.
        if (first(0) < 0 || part.overhangs) return false;
        const int top = end(0);
        for (int j = first(1); j < end(1); ++j)
            for (int k = first(2); k < end(2); ++k)
                if (!part.runs.contains(j, k) || part.runs(j, k).end < top) return false;
        const auto& taken = taken_[static_cast<std::size_t>(index)];
        return std::none_of(taken.begin(), taken.end(), [&](const Box3d& other) {
            for (int a = 0; a < 3; ++a)
                if (box.min[a] >= other.max[a] || box.max[a] <= other.min[a]) return false;
            return true;
        });
    }

    /// Takes the first place (least row, lowest), then whichever is farthest from all that are taken.
    void choose(int axis, Vec3i after, Pair pair, const std::vector<Vec3d>& places) {
        std::vector<double> nearest(places.size(), 1e300);
        std::size_t chosen = 0;
        for (std::size_t next = 0; next < places.size() && chosen < kMostBores; ++chosen) {
            take(axis, after, pair, places[next]);
            const Vec3d last = places[next];
            next = places.size();
            for (std::size_t i = 0; i < places.size(); ++i) {
                const Vec3d apart = places[i] - last;
                nearest[i] = std::min(nearest[i], dot(apart, apart));
                if (nearest[i] >= spacing_ * spacing_ &&
                    (next == places.size() || nearest[i] > nearest[next]) && fits(pair, axis, places[i]))
                    next = i;
            }
        }
        if (chosen == 0) ++joints_.without;
    }

    void take(int axis, Vec3i after, Pair pair, Vec3d centre) {
        const int plane = lines(axis)[static_cast<std::size_t>(after[axis])];
        joints_.bores.push_back({axis, plane, centre, pair.first, pair.second});
        taken_[static_cast<std::size_t>(pair.first)].push_back(room(axis, centre, false));
        taken_[static_cast<std::size_t>(pair.second)].push_back(room(axis, centre, true));
    }

    const PrintLayout& layout_;
    const BlockLines& block_lines_;
    double reach_, depth_, step_, spacing_;
    std::vector<std::vector<Box3d>> taken_;  // for each part
    Joints joints_;
};

}  // namespace

Joints place_joints(const PrintLayout& layout, const BlockLines& lines, const PrintOptions& options) {
    return JointPlacer(layout, lines, options).place();
}

Joints place_joints(const PrintLayout& layout, Vec3d block_mm, const PrintOptions& options) {
    const auto& cuts = layout.cuts.lines;
    return place_joints(layout, block_lines({cuts[0].back(), cuts[1].back(), cuts[2].back()}, block_mm),
                        options);
}

}  // namespace snug
