#include "snug/check/line_hits.h"

#include <algorithm>
#include <array>
#include <optional>

namespace snug {
namespace {

/// Rows or columns of the lattice, both ends included; empty where first > last.
struct Cells {
    int first = 0;
    int last = -1;
};

/// The cells that the units from low to high touch, among `count` cells.
Cells cells_between(std::int32_t low, std::int32_t high, int bits, int count) {
    const auto cell = [bits](std::int32_t units) { return static_cast<int>(units >> bits); };
    return {std::max(cell(low), 0), std::min(cell(high), count - 1)};
}

class Sweep {
  public:
    Sweep(const LineLattice& lattice, std::span<const SnappedVertex> vertices,
          std::span<const Triangle> triangles, const Progress& progress, std::size_t most_hits)
        : lattice_(lattice),
          triangles_(triangles),
          progress_(progress),
          most_hits_(most_hits),
          bits_(lattice.cell_bits()),
          rows_(lattice.lines_along_column()),
          bands_((lattice.rows() - 1) / rows_ + 1),
          vertices_(vertices) {}

    bool run(const std::function<void(const LineBand&)>& visit) {
        if (!sort_triangles_by_first_band()) return false;
        std::vector<std::uint32_t> active;
        for (int j = 0; j < bands_; ++j) {
            const auto band = static_cast<std::size_t>(j);
            active.insert(active.end(), order_.begin() + first_of_band_[band],
                          order_.begin() + first_of_band_[band + 1]);
            const int first = j * rows_, end = std::min(first + rows_, lattice_.rows());
            if (!sweep({first, end - 1}, {0, lattice_.columns() - 1}, active, visit)) return false;
            drop_finished(end - 1, active);
        }
        return true;
    }

  private:
    struct Hit {
        std::uint32_t line;
        Crossing crossing;
    };
    struct Corners {
        SnappedVertex a, b, c;

        /// Whether a line meets the box around them: most lines beside a small triangle do not.
        [[nodiscard]] bool near(std::int32_t u, std::int32_t v) const {
            return u >= std::min({a.u, b.u, c.u}) && u <= std::max({a.u, b.u, c.u}) &&
                   v >= std::min({a.v, b.v, c.v}) && v <= std::max({a.v, b.v, c.v});
        }
        [[nodiscard]] std::optional<Crossing> met_by(std::int32_t u, std::int32_t v) const {
            return near(u, v) ? crossing(u, v, a, b, c) : std::nullopt;
        }
    };

    [[nodiscard]] Corners corners(std::uint32_t triangle) const {
        const Triangle& t = triangles_[triangle];
        return {vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]};
    }

    /// Counts work and asks now and then whether to go on.
    bool worked(std::size_t amount, double fraction) {
        work_ += amount;
        if (work_ < (1u << 18)) return true;
        work_ = 0;
        return go_on(progress_, fraction);
    }

    [[nodiscard]] Cells rows_of(const Corners& t) const {
        return cells_between(std::min({t.a.u, t.b.u, t.c.u}), std::max({t.a.u, t.b.u, t.c.u}), bits_,
                             lattice_.rows());
    }
    [[nodiscard]] Cells columns_of(const Corners& t) const {
        return cells_between(std::min({t.a.v, t.b.v, t.c.v}), std::max({t.a.v, t.b.v, t.c.v}), bits_,
                             lattice_.columns());
    }

    /// The band in which a triangle may meet its first line. Most triangles of a fine scan lie between the
    /// lines.
    [[nodiscard]] std::optional<int> first_band(const Corners& t) const {
        const Cells rows = rows_of(t);
        const Cells columns = columns_of(t);
        if (rows.first > rows.last || columns.first > columns.last) return std::nullopt;
        if (rows.first == rows.last && columns.first == columns.last &&
            !t.met_by(lattice_.u(rows.first, columns.first), lattice_.v(rows.first, columns.first))) {
            return std::nullopt;
        }
        if (doubled_shadow(t.a, t.b, t.c) == 0) return std::nullopt;
        return rows.first / rows_;
    }

    /// A counting sort, which leaves out the triangles that meet no line.
    bool sort_triangles_by_first_band() {
        constexpr int kNone = -1;
        std::vector<std::int16_t> bands(triangles_.size());
        first_of_band_.assign(static_cast<std::size_t>(bands_) + 1, 0);
        for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
            const int band = first_band(corners(i)).value_or(kNone);
            bands[i] = static_cast<std::int16_t>(band);
            if (band != kNone) ++first_of_band_[static_cast<std::size_t>(band) + 1];
            if (!worked(4, 0)) return false;
        }
        for (std::size_t i = 1; i < first_of_band_.size(); ++i) first_of_band_[i] += first_of_band_[i - 1];
        order_.resize(first_of_band_.back());
        std::vector<std::uint32_t> next(first_of_band_.begin(), first_of_band_.end() - 1);
        for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
            if (bands[i] != kNone) order_[next[static_cast<std::size_t>(bands[i])]++] = i;
        }
        return true;
    }

    /// Meets the triangles with a rectangle of lines and shows it, in halves where it has too many crossings.
    bool sweep(Cells rows, Cells columns, std::span<const std::uint32_t> active,
               const std::function<void(const LineBand&)>& visit) {
        const int breadth = columns.last - columns.first + 1;
        const bool divisible = rows.first < rows.last || breadth > rows_;
        if (!collect(rows, columns, active, divisible)) return false;
        if (divisible && hits_.size() > most_hits_) {
            if (rows.first < rows.last) {
                const int middle = (rows.first + rows.last) / 2;
                return sweep({rows.first, middle}, columns, active, visit) &&
                       sweep({middle + 1, rows.last}, columns, active, visit);
            }
            const int middle = columns.first + (breadth / 2 + rows_ - 1) / rows_ * rows_;
            return sweep(rows, {columns.first, middle - 1}, active, visit) &&
                   sweep(rows, {middle, columns.last}, active, visit);
        }
        sort_hits(rows, columns);
        visit(band_);
        return true;
    }

    /// Finds the crossings of a rectangle of lines, or more than the most where it is divisible. False when
    /// cancelled.
    bool collect(Cells rows, Cells columns, std::span<const std::uint32_t> active, bool divisible) {
        hits_.clear();
        const double fraction = static_cast<double>(rows.first) / lattice_.rows();
        for (const std::uint32_t triangle : active) {
            const Corners t = corners(triangle);
            const Cells own = rows_of(t);
            for (int row = std::max(own.first, rows.first); row <= std::min(own.last, rows.last); ++row) {
                const Cells met = columns_of_row(t, row);
                const int last = std::min(met.last, columns.last);
                for (int column = std::max(met.first, columns.first); column <= last; ++column)
                    meet(t, row, column,
                         (row - rows.first) * (columns.last - columns.first + 1) - columns.first);
                if (!worked(static_cast<std::size_t>(std::max(last - met.first, 0)) + 8, fraction))
                    return false;
            }
            if (divisible && hits_.size() > most_hits_) return true;
        }
        return true;
    }

    /// Drops those that do not reach beyond the row.
    void drop_finished(int row, std::vector<std::uint32_t>& active) const {
        active.erase(std::remove_if(active.begin(), active.end(),
                                    [&](std::uint32_t t) { return rows_of(corners(t)).last <= row; }),
                     active.end());
    }

    /// `first_line`: the number within the band that the line of column 0 would have.
    void meet(const Corners& t, int row, int column, int first_line) {
        const std::optional<Crossing> found = t.met_by(lattice_.u(row, column), lattice_.v(row, column));
        if (found) hits_.push_back({static_cast<std::uint32_t>(first_line + column), *found});
    }

    /// The columns where the triangle reaches into this row of lines. Long thin triangles that run across the
    /// lattice would otherwise be tried against every line of their bounding box.
    [[nodiscard]] Cells columns_of_row(const Corners& t, int row) const {
        const Cells all = columns_of(t);
        if (all.last - all.first < 4) return all;
        const double cell = 1 << bits_;
        const double low = row * cell;
        const double high = low + cell;
        double v_min = kBeyond, v_max = -kBeyond;
        const auto include_edge = [&](const SnappedVertex& p, const SnappedVertex& q) {
            const double from = std::max<double>(std::min(p.u, q.u), low);
            const double to = std::min<double>(std::max(p.u, q.u), high);
            if (from > to) return;
            const double slope = q.u == p.u ? 0 : static_cast<double>(q.v - p.v) / (q.u - p.u);
            const double v_from = q.u == p.u ? p.v : p.v + (from - p.u) * slope;
            const double v_to = q.u == p.u ? q.v : p.v + (to - p.u) * slope;
            v_min = std::min({v_min, v_from, v_to});
            v_max = std::max({v_max, v_from, v_to});
        };
        include_edge(t.a, t.b);
        include_edge(t.b, t.c);
        include_edge(t.c, t.a);
        if (v_min > v_max) return {};
        // One unit makes up for the rounding of the slopes.
        const Cells cut = cells_between(static_cast<std::int32_t>(v_min) - 2,
                                        static_cast<std::int32_t>(v_max) + 2, bits_, lattice_.columns());
        return {std::max(all.first, cut.first), std::min(all.last, cut.last)};
    }

    /// From the order of the triangles to the order of the lines, and along each line.
    void sort_hits(Cells rows, Cells columns) {
        band_.first_row = rows.first;
        band_.rows = rows.last - rows.first + 1;
        band_.first_column = columns.first;
        band_.columns = columns.last - columns.first + 1;
        const std::size_t lines = band_.index(rows.last + 1, columns.first);
        const bool was_empty = band_.begin.size() == lines + 1 && band_.crossings.empty();
        if (was_empty && hits_.empty()) return;
        band_.begin.assign(lines + 1, 0);
        for (const Hit& hit : hits_) ++band_.begin[hit.line + 1];
        for (std::size_t i = 1; i <= lines; ++i) band_.begin[i] += band_.begin[i - 1];
        band_.crossings.resize(hits_.size());
        next_.assign(band_.begin.begin(), band_.begin.end() - 1);
        for (const Hit& hit : hits_) band_.crossings[next_[hit.line]++] = hit.crossing;
        for (std::size_t i = 0; i < lines; ++i) {
            if (band_.begin[i + 1] - band_.begin[i] < 2) continue;
            std::sort(band_.crossings.begin() + band_.begin[i], band_.crossings.begin() + band_.begin[i + 1],
                      [](const Crossing& p, const Crossing& q) {
                          return p.x < q.x || (p.x == q.x && p.turn < q.turn);
                      });
        }
    }

    static constexpr double kBeyond = 1e30;

    const LineLattice& lattice_;
    std::span<const Triangle> triangles_;
    const Progress& progress_;
    std::size_t most_hits_;
    int bits_;  ///< of the lattice
    int rows_;  ///< of lines in a band
    int bands_;
    std::size_t work_ = 0;
    std::span<const SnappedVertex> vertices_;
    std::vector<std::uint32_t> order_;          ///< triangles by first band
    std::vector<std::uint32_t> first_of_band_;  ///< into order_
    std::vector<Hit> hits_;                     ///< of the band, in the order of the triangles
    std::vector<std::uint32_t> next_;
    LineBand band_;
};

}  // namespace

Result<void> sweep_lines(const LineLattice& lattice, std::span<const Vec3d> vertices,
                         std::span<const Triangle> triangles,
                         const std::function<void(const LineBand&)>& visit, const Progress& progress,
                         std::size_t most_hits) {
    return sweep_lines(lattice, snapped(lattice, vertices), triangles, visit, progress, most_hits);
}

Result<void> sweep_lines(const LineLattice& lattice, std::span<const SnappedVertex> vertices,
                         std::span<const Triangle> triangles,
                         const std::function<void(const LineBand&)>& visit, const Progress& progress,
                         std::size_t most_hits) {
    if (!Sweep(lattice, vertices, triangles, progress, most_hits).run(visit))
        return fail(ErrorKind::cancelled, say("cancelled"));
    return {};
}

}  // namespace snug
