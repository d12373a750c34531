#pragma once

#include <cstddef>
#include <vector>

#include "snug/design/stress_curve.h"

namespace snug {

/// A column of foam that something may press on.
struct PadColumn {
    double thickness_mm = 0;  ///< of the foam alone, above 0
    /// What is fallen through before all of its foam is squeezed: from the item to the foam, and holes on the
    /// way. Below 0: squeezed as it is drawn.
    double gap_mm = 0;
    double area_mm2 = 0;
    double u_mm = 0, v_mm = 0;  ///< where it stands, across the way that it is pressed
};

/// Columns of foam side by side, each a spring of its own (a Winkler foundation): what they push back with
/// after any travel, in closed form. Of each thickness the columns are sorted by their gaps and summed up, so
/// that a travel costs the thicknesses and the corners of the curve, not the columns.
class Pads {
  public:
    explicit Pads(std::vector<PadColumn> columns);

    [[nodiscard]] bool empty() const { return groups_.empty(); }
    /// The same with so much more foam in every column.
    [[nodiscard]] Pads thicker(double mm) const;

    /// What pushes back after a travel, with the curve's last stress where a column is squeezed beyond it.
    struct Push {
        double newton = 0;
        double u_mm = 0, v_mm = 0;  ///< where it acts; 0 where nothing pushes
    };
    [[nodiscard]] Push push(double travel_mm, const StressCurve& curve) const;
    /// What was taken up on the way from all columns at rest, in joule, and how much of that by columns
    /// thinner than `thin_mm`.
    struct Taken {
        double joule = 0, thin_joule = 0;
    };
    [[nodiscard]] Taken taken(double travel_mm, const StressCurve& curve, double thin_mm = 0) const;

    /// How far it may go until a column reaches this strain; infinite where there is none.
    [[nodiscard]] double travel_to_strain(double strain) const;
    /// The most squeezed column.
    struct Most {
        double strain = 0;
        double u_mm = 0, v_mm = 0;
    };
    [[nodiscard]] Most most_squeezed(double travel_mm) const;
    /// Of the columns that are squeezed.
    [[nodiscard]] double area_mm2(double travel_mm) const;
    /// The least gap, where the item first touches; infinite where there is none.
    [[nodiscard]] double least_gap_mm() const;

  private:
    /// Sums over columns of one thickness, those of the least gaps first; `area_gap`: area * gap and so on.
    struct Sums {
        double area = 0, area_gap = 0, area_gap2 = 0;
        double area_u = 0, area_gap_u = 0, area_v = 0, area_gap_v = 0;
        Sums& operator+=(const Sums& other);
        [[nodiscard]] Sums minus(const Sums& other) const;
    };
    struct Group {
        double thickness_mm = 0;
        std::size_t begin = 0, end = 0;  ///< into gaps_
        std::size_t sums = 0;            ///< into sums_: none of the columns, the first, the first two ...
        double least_gap_mm = 0;
        double u_mm = 0, v_mm = 0;  ///< of the column with the least gap
    };
    /// The sums of a group's columns whose gaps are less than this.
    [[nodiscard]] const Sums& below(const Group& group, double gap_mm) const;
    template <class Visit>
    void for_each_piece(double travel_mm, const StressCurve& curve, Visit visit) const;

    std::vector<double> gaps_;  ///< of the columns, group by group, rising within each
    std::vector<Group> groups_;
    std::vector<Sums> sums_;
};

}  // namespace snug
