#include "snug/foam/gap_volumes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace snug {
namespace {

constexpr int kPerColumn = LineLattice::kPerColumn;
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

GapSampler::GapSampler(const BlockMap& blocks, const DesignSpace& space, int parting_level)
    : blocks_(blocks),
      space_(space),
      parting_(space.face(0, parting_level)),
      halves_(blocks.ny(), blocks.nz()) {}

void GapSampler::add(const LineBand& band) {
    for (int k = 0; k < blocks_.nz(); ++k) {
        const PrismSpan cut = run_of(blocks_(band.j, k), space_);
        auto& column = halves_(band.j, k);
        for (int l = 0; l < kPerColumn; ++l) {
            if (cut.none() && !band.any(l, k)) continue;
            for (int m = 0; m < kPerColumn; ++m) {
                const std::span<const Crossing> line = band.line(l, k * kPerColumn + m);
                // Any odd factor but 1 or 15, whose groups would follow the diagonals.
                const int group = (l + 3 * m) % kGroups;
                combine(lengths_[static_cast<std::size_t>(group)], gap_lengths(line, cut), sum);
                const auto halves = half_lengths(line, cut, parting_);
                for (std::size_t half = 0; half < 2; ++half) {
                    column[half].step += halves[half].step;
                    column[half].undercut += halves[half].undercut;
                }
            }
        }
    }
}

GapVolumes GapSampler::volumes() const {
    GapVolumes total;
    for (const GapVolumes& group : lengths_) combine(total, group, sum);
    combine(total, {}, [this](double length, double) { return length * area_of_line(); });
    return total;
}

std::array<HalfLengths, 2> GapSampler::halves() const {
    std::array<HalfLengths, 2> total;
    for (const auto& column : halves_)
        for (std::size_t half = 0; half < 2; ++half) {
            total[half].step += column[half].step * area_of_line();
            total[half].undercut += column[half].undercut * area_of_line();
        }
    return total;
}

Grid<ColumnGap> GapSampler::columns(bool closed) const {
    Grid<ColumnGap> map(halves_.ny(), halves_.nz());
    const auto mean = [](double lengths) { return static_cast<float>(lengths / (kPerColumn * kPerColumn)); };
    for (std::size_t i = 0; i < map.size(); ++i) {
        const auto& [lower, upper] = halves_[i];
        map[i] = {mean(lower.step), 0, mean(upper.step), 0};
        if (!closed) continue;
        map[i].lower_undercut = mean(lower.undercut);
        map[i].upper_undercut = mean(upper.undercut);
    }
    return map;
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

HullSampler::HullSampler(const DesignSpace& space) : space_(space), lines_per_prism_(1) {
    const auto prisms = [&] {
        const auto along = [&](int columns) {
            return static_cast<std::uint64_t>(columns * kPerColumn / lines_per_prism_);
        };
        return along(space.blocks.y) * along(space.blocks.z);
    };
    while (lines_per_prism_ < kPerColumn && prisms() > kMostPrisms) lines_per_prism_ *= 2;
    spans_ = Grid<PrismSpan>(space.blocks.y * kPerColumn / lines_per_prism_,
                             space.blocks.z * kPerColumn / lines_per_prism_);
}

void HullSampler::add(const LineBand& band) {
    for (int l = 0; l < kPerColumn; ++l) {
        const int row = band.j * kPerColumn + l;
        for (int k = 0; k < space_.blocks.z; ++k) {
            if (!band.any(l, k)) continue;
            for (int column = k * kPerColumn; column < (k + 1) * kPerColumn; ++column) {
                const std::span<const Crossing> line = band.line(l, column);
                if (line.empty()) continue;
                PrismSpan& span = spans_(row / lines_per_prism_, column / lines_per_prism_);
                span.low = std::min(span.low, line.front().x);
                span.high = std::max(span.high, line.back().x);
            }
        }
    }
}

PrismField HullSampler::take() {
    const double part = static_cast<double>(lines_per_prism_) / kPerColumn;
    return PrismField(std::move(spans_), space_.face(1, 0), space_.block_mm.y * part, space_.face(2, 0),
                      space_.block_mm.z * part);
}

}  // namespace snug
