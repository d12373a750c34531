#include "snug/check/gap_volumes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace snug {
namespace {

constexpr std::uint64_t kMostPrisms = 1'000'000;

PrismSpan run_of(CutRun run, const DesignSpace& space) {
    if (run.none()) return {};
    return {space.face(0, run.first), space.face(0, run.end)};
}

double overlap(PrismSpan a, double low, double high) {
    return std::max(std::min(a.high, high) - std::max(a.low, low), 0.0);
}

/// Applies the function to each pair of members.
template <class Function>
void combine(GapVolumes& into, const GapVolumes& other, Function function) {
    into.hull = function(into.hull, other.hull);
    into.solid = function(into.solid, other.solid);
    into.step = function(into.step, other.step);
    into.undercut = function(into.undercut, other.undercut);
}

double sum(double a, double b) {
    return a + b;
}

}  // namespace

GapVolumes gap_lengths(std::span<const Crossing> crossings, PrismSpan cut) {
    GapVolumes lengths;
    const double cut_length = cut.none() ? 0 : cut.high - cut.low;
    if (crossings.empty()) {
        lengths.step = cut_length;
        return lengths;
    }
    const double first = crossings.front().x;
    const double last = crossings.back().x;
    double solid_in_cut = 0;
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        winding += crossings[i].turn;
        if (winding == 0) continue;
        lengths.solid += crossings[i + 1].x - crossings[i].x;
        solid_in_cut += overlap(cut, crossings[i].x, crossings[i + 1].x);
    }
    const double hull_in_cut = overlap(cut, first, last);
    lengths.hull = last - first;
    lengths.step = cut_length - hull_in_cut;
    lengths.undercut = hull_in_cut - solid_in_cut;
    return lengths;
}

std::array<HalfLengths, 2> half_lengths(std::span<const Crossing> crossings, PrismSpan cut, double parting) {
    std::array<HalfLengths, 2> halves;
    auto& [lower, upper] = halves;
    if (cut.none()) return halves;
    if (crossings.empty()) {
        lower.step = overlap(cut, cut.low, parting);
        upper.step = overlap(cut, parting, cut.high);
        return halves;
    }
    const double first = crossings.front().x, last = crossings.back().x;
    lower.step = overlap(cut, cut.low, first);
    upper.step = overlap(cut, last, cut.high);
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        winding += crossings[i].turn;
        if (winding != 0) continue;
        const double begin = crossings[i].x, end = crossings[i + 1].x;
        lower.undercut += overlap(cut, begin, std::min(end, parting));
        upper.undercut += overlap(cut, std::max(begin, parting), end);
    }
    return halves;
}

GapSampler::GapSampler(const BlockMap& blocks, const DesignSpace& space, const LineLattice& lattice,
                       int parting_level)
    : blocks_(blocks),
      space_(space),
      lattice_(lattice),
      parting_(space.face(0, parting_level)),
      open_(static_cast<std::size_t>(lattice.columns() / lattice.lines_along_column())),
      columns_(blocks.ny(), blocks.nz()) {}

void GapSampler::add(const LineBand& band) {
    const int lines = lattice_.lines_along_column();
    if (band.first_row / lines != row_ / lines) finish_columns();
    row_ = band.first_row;
    for (int first = band.first_column; first < band.end_column(); first += lines) {
        for (int row = band.first_row; row < band.end_row(); ++row) {
            const CutRun run = blocks_(lattice_.j(row, first), lattice_.k(row, first));
            if (run.none() && !band.any(row, first, first + lines)) continue;
            const PrismSpan cut = run_of(run, space_);
            for (int column = first; column < first + lines; ++column)
                add_line(band.line(row, column), row, column, cut);
        }
    }
}

void GapSampler::add_line(std::span<const Crossing> line, int row, int column, PrismSpan cut) {
    const double share = lattice_.share(row, column);
    const auto add_share = [share](double a, double b) { return a + b * share; };
    // Any odd factor but 1 or 15, whose groups would follow the diagonals.
    const int group = (row + 3 * column) % kGroups;
    combine(lengths_[static_cast<std::size_t>(group)], gap_lengths(line, cut), add_share);
    auto& open = open_[static_cast<std::size_t>(column / lattice_.lines_along_column())];
    const auto halves = half_lengths(line, cut, parting_);
    for (std::size_t half = 0; half < 2; ++half) {
        open[half].step += halves[half].step * share;
        open[half].undercut += halves[half].undercut * share;
    }
}

void GapSampler::finish_columns() {
    const int lines = lattice_.lines_along_column(), breadth = lattice_.columns_along_cell();
    const int j_first = row_ / lines * breadth, j_end = std::min(j_first + breadth, blocks_.ny());
    for (std::size_t i = 0; i < open_.size(); ++i) {
        auto& [lower, upper] = open_[i];
        for (std::size_t half = 0; half < 2; ++half) {
            halves_[half].step += open_[i][half].step * area_of_line();
            halves_[half].undercut += open_[i][half].undercut * area_of_line();
        }
        const double all = lines * lines * lattice_.share(row_, static_cast<int>(i) * lines);
        const auto mean = [all](double lengths) { return static_cast<float>(lengths / all); };
        const ColumnGap gap{mean(lower.step), mean(lower.undercut), mean(upper.step), mean(upper.undercut)};
        open_[i] = {};
        if (gap == ColumnGap()) continue;
        const int k_first = static_cast<int>(i) * breadth, k_end = std::min(k_first + breadth, blocks_.nz());
        for (int j = j_first; j < j_end; ++j)
            for (int k = k_first; k < k_end; ++k)
                if (!blocks_(j, k).none()) columns_(j, k) = gap;
    }
}

GapVolumes GapSampler::volumes() const {
    GapVolumes total;
    for (const GapVolumes& group : lengths_) combine(total, group, sum);
    combine(total, {}, [this](double length, double) { return length * area_of_line(); });
    return total;
}

Grid<ColumnGap> GapSampler::columns(bool closed) {
    if (!closed)
        for (ColumnGap& column : columns_) column.lower_undercut = column.upper_undercut = 0;
    return std::move(columns_);
}

GapVolumes GapSampler::errors() const {
    GapVolumes mean;
    for (const GapVolumes& group : lengths_) combine(mean, group, sum);
    combine(mean, {}, [](double total, double) { return total / kGroups; });
    GapVolumes squares;
    for (GapVolumes deviation : lengths_) {
        combine(deviation, mean, [](double a, double b) { return (a - b) * (a - b); });
        combine(squares, deviation, sum);
    }
    // The sum of the groups has kGroups times the variance of one.
    combine(squares, {}, [this](double squared, double) {
        return 2 * area_of_line() * std::sqrt(squared * kGroups / (kGroups - 1));
    });
    return squares;
}

HullSampler::HullSampler(const DesignSpace& space, const LineLattice& lattice)
    : space_(space), lattice_(lattice), lines_per_prism_(1) {
    const auto along = [&](int lines) { return (lines - 1) / lines_per_prism_ + 1; };
    const auto prisms = [&] {
        return static_cast<std::uint64_t>(along(lattice.rows())) *
               static_cast<std::uint64_t>(along(lattice.columns()));
    };
    while (lines_per_prism_ < lattice.lines_along_column() && prisms() > kMostPrisms) lines_per_prism_ *= 2;
    spans_ = Grid<PrismSpan>(along(lattice.rows()), along(lattice.columns()));
}

void HullSampler::add(const LineBand& band) {
    for (int row = band.first_row; row < band.end_row(); ++row) {
        if (!band.any(row, band.first_column, band.end_column())) continue;
        for (int column = band.first_column; column < band.end_column(); ++column) {
            const std::span<const Crossing> line = band.line(row, column);
            if (line.empty()) continue;
            PrismSpan& span = spans_(row / lines_per_prism_, column / lines_per_prism_);
            span.low = std::min(span.low, line.front().x);
            span.high = std::max(span.high, line.back().x);
        }
    }
}

PrismField HullSampler::take() {
    const double lines = lattice_.lines_along_column();
    const double part = lines_per_prism_ / lines * lattice_.columns_along_cell();
    return PrismField(std::move(spans_), space_.face(1, 0), space_.block_mm.y * part, space_.face(2, 0),
                      space_.block_mm.z * part);
}

}  // namespace snug
