#include "bench/random_merge.h"

#include <algorithm>
#include <utility>

#include "snug/base/seeded_numbers.h"

namespace snug::bench {
namespace {

constexpr int kMostFailures = 100, kFailuresOfRing = 10;

/// A brick while it may still be merged: cells of one layer.
struct Piece {
    int layer = 0, row = 0, column = 0, rows = 1, columns = 1;
    bool alive = true;
};

int set_of(std::vector<int>& leader, int i) {
    while (leader[i] != i) i = leader[i] = leader[leader[i]];
    return i;
}

class Layout {
  public:
    Layout(const BrickHeights& heights, const MergeOptions& options)
        : heights_(heights), options_(options), random_(options.seed) {
        int layers = 0;
        for (const std::uint16_t height : heights) layers = std::max<int>(layers, height);
        cells_.assign(layers, Grid<int>(heights.ny(), heights.nz(), -1));
        for (int layer = 0; layer < layers; ++layer)
            for (int row = 0; row < heights.ny(); ++row)
                for (int column = 0; column < heights.nz(); ++column)
                    if (heights(row, column) > layer) place({layer, row, column});
        std::vector<Pair> pairs;
        for (int i = 0; i < static_cast<int>(pieces_.size()); ++i) add_pairs(i, pairs);
        merge(std::move(pairs));
    }

    void connect() {
        int failures = 0;
        auto [components, count] = components_of();
        while (count > 1 && failures < kMostFailures) {
            const int seed = seed_of(components);
            if (seed < 0) return;  // the pieces touch nowhere
            const auto old_pieces = pieces_;
            const auto old_cells = cells_;
            reconfigure(seed, failures / kFailuresOfRing + 1);
            auto now = components_of();
            if (now.second < count) {
                components = std::move(now.first);
                count = now.second;
                failures = 0;
            } else {
                pieces_ = old_pieces;
                cells_ = old_cells;
                ++failures;
            }
        }
    }

    [[nodiscard]] BrickBuild build() const {
        const int high = options_.kind == BrickKind::brick ? kPlatesInBrick : 1;
        BrickBuild build;
        build.rows = heights_.ny();
        build.columns = heights_.nz();
        for (const Piece& p : pieces_)
            if (p.alive)
                build.bricks.push_back({options_.kind, p.row, p.column, p.rows, p.columns, p.layer * high});
        std::sort(build.bricks.begin(), build.bricks.end(), [](const Brick& a, const Brick& b) {
            if (a.bottom != b.bottom) return a.bottom < b.bottom;
            return a.row != b.row ? a.row < b.row : a.column < b.column;
        });
        return build;
    }

  private:
    using Pair = std::pair<int, int>;

    int place(const Piece& piece) {
        const int number = static_cast<int>(pieces_.size());
        pieces_.push_back(piece);
        for (int row = piece.row; row < piece.row + piece.rows; ++row)
            for (int column = piece.column; column < piece.column + piece.columns; ++column)
                cells_[piece.layer](row, column) = number;
        return number;
    }

    [[nodiscard]] int at(int layer, int row, int column) const {
        if (layer < 0 || layer >= static_cast<int>(cells_.size())) return -1;
        return cells_[layer].contains(row, column) ? cells_[layer](row, column) : -1;
    }

    [[nodiscard]] bool in_family(int rows, int columns) const {
        const BrickSize size{std::min(rows, columns), std::max(rows, columns)};
        return std::find(options_.family.begin(), options_.family.end(), size) != options_.family.end();
    }

    /// The pairs of one piece with its four neighbours that a brick of the family can replace.
    void add_pairs(int number, std::vector<Pair>& pairs) const {
        const Piece& p = pieces_[number];
        const auto try_beside = [&](int row, int column) {
            const int other = at(p.layer, row, column);
            if (other < 0) return;
            const Piece& q = pieces_[other];
            const bool along_columns = q.row == p.row && q.rows == p.rows;
            const bool along_rows = q.column == p.column && q.columns == p.columns;
            if (along_columns ? in_family(p.rows, p.columns + q.columns)
                              : along_rows && in_family(p.rows + q.rows, p.columns))
                pairs.emplace_back(number, other);
        };
        try_beside(p.row, p.column + p.columns);
        try_beside(p.row, p.column - 1);
        try_beside(p.row + p.rows, p.column);
        try_beside(p.row - 1, p.column);
    }

    /// Merges random pairs until none is left.
    void merge(std::vector<Pair> pairs) {
        while (!pairs.empty()) {
            const int chosen = random_.below(static_cast<int>(pairs.size()));
            const auto [a, b] = pairs[chosen];
            pairs[chosen] = pairs.back();
            pairs.pop_back();
            if (!pieces_[a].alive || !pieces_[b].alive) continue;
            pieces_[a].alive = pieces_[b].alive = false;
            const Piece p = pieces_[a], q = pieces_[b];
            Piece merged{p.layer, std::min(p.row, q.row), std::min(p.column, q.column), p.rows, p.columns};
            if (p.row == q.row && p.rows == q.rows)
                merged.columns += q.columns;
            else
                merged.rows += q.rows;
            add_pairs(place(merged), pairs);
        }
    }

    /// All pieces that touch this one: at its sides, above and below.
    [[nodiscard]] std::vector<int> ring_of(int number) const {
        const Piece& p = pieces_[number];
        std::vector<int> ring;
        const auto look = [&](int layer, int row, int column) {
            if (const int other = at(layer, row, column); other >= 0) ring.push_back(other);
        };
        for (int row = p.row; row < p.row + p.rows; ++row) {
            look(p.layer, row, p.column - 1);
            look(p.layer, row, p.column + p.columns);
        }
        for (int column = p.column; column < p.column + p.columns; ++column) {
            look(p.layer, p.row - 1, column);
            look(p.layer, p.row + p.rows, column);
            for (int row = p.row; row < p.row + p.rows; ++row) {
                look(p.layer - 1, row, column);
                look(p.layer + 1, row, column);
            }
        }
        std::sort(ring.begin(), ring.end());
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
        return ring;
    }

    /// Of each piece its connected component, and how many there are.
    [[nodiscard]] std::pair<std::vector<int>, int> components_of() const {
        std::vector<int> leader(pieces_.size());
        for (int i = 0; i < static_cast<int>(leader.size()); ++i) leader[i] = i;
        for (std::size_t layer = 1; layer < cells_.size(); ++layer)
            for (std::size_t cell = 0; cell < cells_[layer].size(); ++cell) {
                const int upper = cells_[layer][cell], lower = cells_[layer - 1][cell];
                if (upper >= 0 && lower >= 0) leader[set_of(leader, upper)] = set_of(leader, lower);
            }
        int count = 0;
        for (int i = 0; i < static_cast<int>(leader.size()); ++i)
            count += pieces_[i].alive && set_of(leader, i) == i;
        for (int i = 0; i < static_cast<int>(leader.size()); ++i) leader[i] = set_of(leader, i);
        return {std::move(leader), count};
    }

    /// A piece that touches other components, the likelier the more they are; -1: there is none.
    int seed_of(const std::vector<int>& components) {
        std::vector<int> others(pieces_.size());
        int sum = 0;
        for (int i = 0; i < static_cast<int>(pieces_.size()); ++i) {
            if (!pieces_[i].alive) continue;
            std::vector<int> seen;
            for (const int other : ring_of(i))
                if (components[other] != components[i]) seen.push_back(components[other]);
            std::sort(seen.begin(), seen.end());
            others[i] = static_cast<int>(std::unique(seen.begin(), seen.end()) - seen.begin());
            sum += others[i];
        }
        if (sum == 0) return -1;
        int left = random_.below(sum), chosen = 0;
        while (left >= others[chosen]) left -= others[chosen++];
        return chosen;
    }

    /// Takes all within `reach` rings around the piece apart, and merges anew.
    void reconfigure(int seed, int reach) {
        std::vector<char> inside(pieces_.size());
        std::vector<int> taken{seed}, edge{seed};
        inside[seed] = 1;
        for (int step = 0; step < reach; ++step) {
            std::vector<int> next;
            for (const int number : edge)
                for (const int other : ring_of(number))
                    if (!inside[other]) {
                        inside[other] = 1;
                        next.push_back(other);
                    }
            taken.insert(taken.end(), next.begin(), next.end());
            edge = std::move(next);
        }
        std::vector<int> single;
        for (const int number : taken) {
            const Piece p = pieces_[number];
            pieces_[number].alive = false;
            for (int row = p.row; row < p.row + p.rows; ++row)
                for (int column = p.column; column < p.column + p.columns; ++column)
                    single.push_back(place({p.layer, row, column}));
        }
        std::vector<Pair> pairs;
        for (const int number : single) add_pairs(number, pairs);
        merge(std::move(pairs));
    }

    const BrickHeights& heights_;
    const MergeOptions& options_;
    SeededNumbers random_;
    std::vector<Piece> pieces_;
    std::vector<Grid<int>> cells_;  ///< of each layer: the piece of each cell, -1: none
};

}  // namespace

std::vector<BrickSize> luo_family() {
    return {{1, 1}, {1, 2}, {1, 3}, {1, 4}, {1, 6}, {1, 8}, {2, 2}, {2, 3}, {2, 4}, {2, 6}, {2, 8}};
}

BrickBuild random_merge(const BrickHeights& heights, const MergeOptions& options) {
    Layout layout(heights, options);
    layout.connect();
    return layout.build();
}

}  // namespace snug::bench
