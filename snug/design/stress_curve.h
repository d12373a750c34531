#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "snug/base/message.h"

namespace snug {

/// What a foam presses with where it is squeezed by a share of its thickness.
struct StressPoint {
    double strain = 0;  ///< above 0, below 1
    double kpa = 0;
    friend bool operator==(const StressPoint&, const StressPoint&) = default;
};

/// What is wrong with such points, as what they must be; none where they make a curve: 2 to 1000, strains
/// that rise between 0 and 1, stresses above 0 that never fall.
[[nodiscard]] std::optional<Message> problem_of(std::span<const StressPoint> points);

/// The compressive stress of a foam over its strain: straight lines between the points from (0, 0); what lies
/// beyond the last is not known. Only sums, products and quotients, so that every build gives the same.
class StressCurve {
  public:
    /// Without the (0, 0) that every curve begins with. `points` must have no problem_of().
    explicit StressCurve(std::span<const StressPoint> points);

    /// Stress and what was taken up per volume: kPa both, since 1 kPa is 1 kJ/m3.
    struct Value {
        double kpa = 0;
        double energy = 0;
    };
    /// At a strain; 0 below 0, as at the last point beyond it.
    [[nodiscard]] Value at(double strain) const;

    /// The corners of the curve, (0, 0) first, and what is taken up there.
    struct Corner {
        double strain = 0, kpa = 0, energy = 0;
    };
    [[nodiscard]] std::span<const Corner> corners() const { return corners_; }
    [[nodiscard]] double greatest_strain() const { return corners_.back().strain; }

    /// The strain that takes up a fall from `height` times the thickness under a static stress, the way
    /// through the foam included: stress * (height + strain) = energy(strain). None where it bottoms.
    [[nodiscard]] std::optional<double> strain_of_drop(double stress_kpa, double height) const;

  private:
    std::vector<Corner> corners_;
};

/// The foam of a drop-tested cushion of closed cells: a plateau, which is full at 5 % of strain, and the air
/// in the cells, pressed together at one temperature. `solid_share`: density over that of the polymer; `air`:
/// how much of the air stays in, 1 in closed cells. Points each 1/40 of strain up to `greatest_strain`.
[[nodiscard]] std::vector<StressPoint> closed_cell_points(double plateau_kpa, double solid_share,
                                                          double greatest_strain, double air = 1);

/// The part of a curve that is not the air of closed cells: its stress at 5 % of strain less that of the air,
/// 5 to 70 kPa, the range of soft polyethylene foams from a slow test to a drop.
[[nodiscard]] double plateau_kpa(const StressCurve& curve);

/// The curves that a foam may have which was pressed slowly and not dropped on: the same with plateaus from 5
/// to 70 kPa in steps of 5.
[[nodiscard]] std::vector<StressCurve> with_other_plateaus(std::span<const StressPoint> points);

}  // namespace snug
