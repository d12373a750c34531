#pragma once

#include <array>
#include <span>
#include <vector>

#include "snug/base/grid.h"
#include "snug/check/gap.h"
#include "snug/check/line_hits.h"
#include "snug/check/prism_field.h"
#include "snug/foam/block_map.h"
#include "snug/space/design_space.h"

namespace snug {

/// Volumes in mm3, or lengths in mm along one line; see GapFigures.
struct GapVolumes {
    double hull = 0;
    double solid = 0;
    double step = 0;
    double undercut = 0;
};

/// Of one line: its crossings by x, and the cut run of its column.
[[nodiscard]] GapVolumes gap_lengths(std::span<const Crossing> crossings, PrismSpan cut);

/// The same of one line, of what each half faces (HalfGap): lower, then upper. `parting`: x of the parting
/// level.
struct HalfLengths {
    double step = 0;
    double undercut = 0;
};
[[nodiscard]] std::array<HalfLengths, 2> half_lengths(std::span<const Crossing> crossings, PrismSpan cut,
                                                      double parting);

/// Adds up lines, band by band.
class GapSampler {
  public:
    GapSampler(const BlockMap& blocks, const DesignSpace& space, const LineLattice& lattice,
               int parting_level);

    void add(const LineBand& band);

    /// Sums up the last columns. After this nothing can be added.
    void finish() { finish_columns(); }

    [[nodiscard]] GapVolumes volumes() const;
    /// mm3 of the lower half, then of the upper.
    [[nodiscard]] std::array<HalfLengths, 2> halves() const { return halves_; }
    /// Where a line stands for several columns, those that are cut get its depths. Takes them out.
    [[nodiscard]] Grid<ColumnGap> columns(bool closed);

    /// The standard error of the mean of 16 estimates, each from a sixteenth of the lines that has one line
    /// in every row and every column of 16 x 16 lines. The lines of all sixteenths lie more evenly than
    /// chance would have it, so this is mostly a few times larger than the true error.
    [[nodiscard]] GapVolumes errors() const;

  private:
    static constexpr int kGroups = LineLattice::kPerColumn;

    [[nodiscard]] double area_of_line() const {
        return space_.block_mm.y * space_.block_mm.z / lattice_.lines_per_column();
    }
    void add_line(std::span<const Crossing> line, int row, int column, PrismSpan cut);
    void finish_columns();

    const BlockMap& blocks_;
    const DesignSpace& space_;
    const LineLattice& lattice_;
    double parting_;
    int row_ = 0;  ///< of the lattice: the first that `open_` holds
    /// Of the row of columns (or of cells larger than one) that is being added: sums over each one's lines.
    std::vector<std::array<HalfLengths, 2>> open_;
    std::array<HalfLengths, 2> halves_{};
    Grid<ColumnGap> columns_;
    std::array<GapVolumes, kGroups> lengths_{};  ///< summed for each sixteenth of the lines
};

/// Between the first and last hit of each line, for a whole object: a prism a line, or where that would take
/// too much memory a prism for 2 x 2, 4 x 4 ... lines that reaches as far as any of them.
class HullSampler {
  public:
    HullSampler(const DesignSpace& space, const LineLattice& lattice);

    void add(const LineBand& band);

    [[nodiscard]] PrismField take();

  private:
    const DesignSpace& space_;
    const LineLattice& lattice_;
    int lines_per_prism_;  ///< along each axis
    Grid<PrismSpan> spans_;
};

}  // namespace snug
