#include "snug/search/mask_rooms.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace snug {
namespace {

constexpr int kFirstPatience = 12, kMostPatience = 400;  // rounds without anything better

const MaskShape& shape_of(const MaskProblem& problem, int shape) {
    return problem.shapes[static_cast<std::size_t>(shape)];
}

/// What a layout takes up, from the first row and column.
PackedMasks packed(const MaskProblem& problem, const MaskLayout& layout) {
    PackedMasks result;
    result.layout = layout;
    for (const LaidMask& at : layout) {
        result.rows = std::max(result.rows, at.row + shape_of(problem, at.shape).mask.rows());
        result.columns = std::max(result.columns, at.column + shape_of(problem, at.shape).mask.columns());
    }
    return result;
}

/// Everything by the first row and column.
void pull_to_corner(MaskLayout& layout) {
    int row = std::numeric_limits<int>::max(), column = row;
    for (const LaidMask& at : layout) {
        row = std::min(row, at.row);
        column = std::min(column, at.column);
    }
    for (LaidMask& at : layout) {
        at.row -= row;
        at.column -= column;
    }
}

/// What the pieces take at least, grown by the gap: each room is as much larger.
class LeastRoom {
  public:
    LeastRoom(const MaskProblem& problem, const RoomTask& task) : problem_(problem), task_(task) {
        for (const MaskPiece& piece : problem.pieces) {
            long long least = std::numeric_limits<long long>::max();
            for (const int shape : piece.shapes) {
                const BitMask& mask = shape_of(problem, shape).mask;
                least = std::min(least, piece.group < 0 ? grown(mask, problem.gap).count() : mask.count());
            }
            columns_ += least;
        }
    }
    [[nodiscard]] bool may_hold(int rows, int columns) const {
        const long long all = 1LL * (rows + problem_.gap.rows) * (columns + problem_.gap.columns) *
                              static_cast<long long>(task_.heights.size());
        return all >= columns_ && each_fits(rows, columns);
    }

  private:
    [[nodiscard]] bool each_fits(int rows, int columns) const {
        const int highest = *std::max_element(task_.heights.begin(), task_.heights.end());
        return std::all_of(problem_.pieces.begin(), problem_.pieces.end(), [&](const MaskPiece& piece) {
            return std::any_of(piece.shapes.begin(), piece.shapes.end(), [&](int shape) {
                const MaskShape& laid = shape_of(problem_, shape);
                return laid.mask.rows() <= rows && laid.mask.columns() <= columns && laid.height <= highest;
            });
        });
    }

    const MaskProblem& problem_;
    const RoomTask& task_;
    long long columns_ = 0;
};

/// The columns that a room of so many rows may have for less than a price; 0: none.
int columns_below(long long price, int rows, const RoomTask& task) {
    int low = 0, high = task.most_columns;
    while (low < high) {
        const int middle = low + (high - low + 1) / 2;
        if (task.price(rows, middle) < price)
            low = middle;
        else
            high = middle - 1;
    }
    return low;
}

/// A room that would be better than the best so far.
struct BetterRoom {
    int rows = 0, columns = 0;
    long long clashes = -1;  ///< that the best layout in it had; -1: not looked at
    MaskLayout layout;       ///< this one
    int patience = kFirstPatience;
};

class RoomSearch {
  public:
    RoomSearch(MaskPacker& packer, const RoomTask& task, const BetterPacking& better)
        : packer_(packer), task_(task), better_(better), least_(packer.problem(), task) {
        best_.price = task.known_price < 0 ? std::numeric_limits<long long>::max() : task.known_price;
    }

    std::optional<PackedMasks> run() {
        lay_in_rows();
        while (go_on()) {
            choose_candidates();
            if (candidates_.empty()) break;
            for (int round = 0; go_on() && !look_at(round); ++round) {
            }
        }
        if (best_.layout.empty()) return {};
        return best_;
    }

  private:
    [[nodiscard]] bool go_on() const { return !packer_.cancelled() && packer_.work() < task_.work; }

    void offer(MaskLayout layout) {
        pull_to_corner(layout);
        PackedMasks found = packed(packer_.problem(), layout);
        found.price = task_.price(found.rows, found.columns);
        if (found.price >= best_.price) return;
        best_ = std::move(found);
        if (better_) better_(best_);
    }

    /// A first answer for every number of rows, without any clash: the strip is long enough for all.
    void lay_in_rows() {
        int longest = 1, most = 0;
        for (const MaskPiece& piece : packer_.problem().pieces) {
            int own = 0;
            for (const int shape : piece.shapes) {
                const BitMask& mask = shape_of(packer_.problem(), shape).mask;
                own = std::max({own, mask.rows() + packer_.problem().gap.rows, mask.columns()});
            }
            longest = std::max(longest, own);
            most += own;
        }
        const int end = std::min(task_.most_columns, most);
        const int step = std::max(1, end / 24);
        for (int columns = 1; columns <= end && go_on(); columns += step) {
            const MaskRoom strip{std::min(task_.most_rows, most), columns, task_.heights, {}};
            if (!packer_.each_fits(strip)) continue;
            MaskLayout layout = packer_.laid_in_order(strip, 0);
            if (packer_.clashes(strip, layout) == 0) offer(std::move(layout));
        }
    }

    /// For each number of rows the most columns that cost less than the best: what holds the pieces with
    /// fewer holds them with more.
    void choose_candidates() {
        std::vector<BetterRoom> all;
        int before = task_.most_columns + 1;
        for (int rows = task_.most_rows; rows > 0; --rows) {
            const int columns = columns_below(best_.price, rows, task_);
            if (columns == 0 || (columns == before && rows < task_.most_rows)) continue;
            before = columns;
            if (!least_.may_hold(rows, columns)) continue;
            const auto same = std::find_if(candidates_.begin(), candidates_.end(), [&](const BetterRoom& c) {
                return c.rows == rows && c.columns == columns;
            });
            all.push_back(same == candidates_.end() ? BetterRoom{rows, columns, -1, {}} : *same);
        }
        candidates_ = std::move(all);
    }

    /// All of them in the first of four rounds, then the nearest to success alone.
    bool look_at(int round) {
        std::stable_sort(candidates_.begin(), candidates_.end(),
                         [](const BetterRoom& a, const BetterRoom& b) { return a.clashes < b.clashes; });
        const std::size_t count = std::max<std::size_t>(1, candidates_.size() >> (round % 4));
        for (std::size_t i = 0; i < count && go_on(); ++i)
            if (look_at(candidates_[i])) return true;
        return false;
    }

    /// True where it holds the pieces.
    bool look_at(BetterRoom& candidate) {
        const MaskRoom room{candidate.rows, candidate.columns, task_.heights, {}};
        MaskLayout layout;
        if (candidate.layout.empty() || packer_.numbers().below(3) == 0) {
            layout = packer_.laid_in_order(room, candidate.layout.empty() ? 0.2 : 0.8);
        } else {
            layout = candidate.layout;
            for (int i = packer_.numbers().below(3); i >= 0; --i) packer_.disturb(room, layout);
        }
        if (packer_.separate(room, layout, candidate.patience, task_.work)) {
            offer(std::move(layout));
            return true;
        }
        candidate.patience = std::min(kMostPatience, candidate.patience * 5 / 4);
        const long long clashes = packer_.clashes(room, layout);
        if (candidate.clashes < 0 || clashes <= candidate.clashes) {
            candidate.clashes = clashes;
            candidate.layout = std::move(layout);
        }
        return false;
    }

    MaskPacker& packer_;
    const RoomTask& task_;
    const BetterPacking& better_;
    LeastRoom least_;
    PackedMasks best_;
    std::vector<BetterRoom> candidates_;
};

}  // namespace

std::optional<PackedMasks> smallest_room(MaskPacker& packer, const RoomTask& task,
                                         const BetterPacking& better) {
    return RoomSearch(packer, task, better).run();
}

std::optional<PackedMasks> shortest_strip(MaskPacker& packer, int columns, long long work,
                                          const BetterPacking& better) {
    int rows = 0;
    for (const MaskPiece& piece : packer.problem().pieces) {
        int own = 0;
        for (const int shape : piece.shapes)
            own = std::max(own, shape_of(packer.problem(), shape).mask.rows() + packer.problem().gap.rows);
        rows += own;
    }
    MaskRoom room{rows, columns, {std::numeric_limits<int>::max()}, {}};
    if (!packer.each_fits(room)) return {};
    PackedMasks best = packed(packer.problem(), packer.laid_in_order(room, 0));
    best.price = best.rows;
    if (better) better(best);
    const auto go_on = [&] { return !packer.cancelled() && packer.work() < work; };
    int step = std::max(1, best.rows / 40), patience = 40, failed = 0;
    MaskLayout last;  // the best that did not go in
    while (go_on()) {
        room.rows = best.rows - step;
        if (!packer.each_fits(room)) {
            if (step == 1) break;
            step = std::max(1, step / 2);
            continue;
        }
        const bool again = failed > 0 && packer.numbers().below(4) != 0;
        MaskLayout layout = again ? last : best.layout;
        packer.bring_inside(room, layout);
        for (int i = 0; i < failed && i < 3; ++i) packer.disturb(room, layout);
        if (packer.separate(room, layout, patience, work)) {
            best = packed(packer.problem(), layout);
            best.price = best.rows;
            if (better) better(best);
            failed = 0;
        } else {
            last = std::move(layout);
            if (++failed < 3) continue;
            if (step > 1) failed = 0;
            step = std::max(1, step / 2);
            patience = std::min(kMostPatience, patience * 5 / 4);
        }
    }
    return best;
}

bool may_hold(const MaskProblem& problem, const MaskRoom& room) {
    RoomTask task;
    task.heights = room.heights;
    return LeastRoom(problem, task).may_hold(room.rows, room.columns);
}

long long least_price(const MaskProblem& problem, const RoomTask& task) {
    const LeastRoom least(problem, task);
    long long price = std::numeric_limits<long long>::max();
    for (int rows = 1; rows <= task.most_rows; ++rows) {
        if (!least.may_hold(rows, task.most_columns)) continue;
        int low = 1, high = task.most_columns;
        while (low < high) {
            const int middle = (low + high) / 2;
            if (least.may_hold(rows, middle))
                high = middle;
            else
                low = middle + 1;
        }
        price = std::min(price, task.price(rows, low));
    }
    return price;
}

}  // namespace snug
