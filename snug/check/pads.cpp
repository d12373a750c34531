#include "snug/check/pads.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace snug {

Pads::Sums& Pads::Sums::operator+=(const Sums& o) {
    area += o.area;
    area_gap += o.area_gap;
    area_gap2 += o.area_gap2;
    area_u += o.area_u;
    area_gap_u += o.area_gap_u;
    area_v += o.area_v;
    area_gap_v += o.area_gap_v;
    return *this;
}

Pads::Sums Pads::Sums::minus(const Sums& o) const {
    return {area - o.area,
            area_gap - o.area_gap,
            area_gap2 - o.area_gap2,
            area_u - o.area_u,
            area_gap_u - o.area_gap_u,
            area_v - o.area_v,
            area_gap_v - o.area_gap_v};
}

Pads::Pads(std::vector<PadColumn> columns) {
    std::sort(columns.begin(), columns.end(), [](const PadColumn& a, const PadColumn& b) {
        return std::tie(a.thickness_mm, a.gap_mm, a.u_mm, a.v_mm) <
               std::tie(b.thickness_mm, b.gap_mm, b.u_mm, b.v_mm);
    });
    gaps_.reserve(columns.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const auto& [thickness, gap, area, u, v] = columns[i];
        if (groups_.empty() || groups_.back().thickness_mm != thickness) {
            groups_.push_back({thickness, i, i, sums_.size(), gap, u, v});
            sums_.emplace_back();
        }
        groups_.back().end = i + 1;
        gaps_.push_back(gap);
        Sums next = sums_.back();
        next += Sums{area, area * gap, area * gap * gap, area * u, area * gap * u, area * v, area * gap * v};
        sums_.push_back(next);
    }
}

Pads Pads::thicker(double mm) const {
    Pads other = *this;
    for (Group& group : other.groups_) group.thickness_mm += mm;
    return other;
}

const Pads::Sums& Pads::below(const Group& group, double gap_mm) const {
    const auto begin = gaps_.begin() + static_cast<std::ptrdiff_t>(group.begin);
    const auto end = gaps_.begin() + static_cast<std::ptrdiff_t>(group.end);
    return sums_[group.sums + static_cast<std::size_t>(std::lower_bound(begin, end, gap_mm) - begin)];
}

/// Shows, of each thickness, the columns between two corners of the curve: their sums, the corner that their
/// strain has passed and the slope behind it, 0 behind the last.
template <class Visit>
void Pads::for_each_piece(double travel_mm, const StressCurve& curve, Visit visit) const {
    const auto corners = curve.corners();
    for (const Group& group : groups_) {
        if (group.least_gap_mm >= travel_mm) continue;
        const Sums* less = &below(group, travel_mm);  // strained at all
        for (std::size_t i = 0; i < corners.size() && less->area > 0; ++i) {
            const bool last = i + 1 == corners.size();
            static constexpr Sums kNone{};
            const Sums* more =
                last ? &kNone : &below(group, travel_mm - corners[i + 1].strain * group.thickness_mm);
            const double slope =
                last ? 0
                     : (corners[i + 1].kpa - corners[i].kpa) / (corners[i + 1].strain - corners[i].strain);
            visit(group, less->minus(*more), corners[i], slope);
            less = more;
        }
    }
}

Pads::Push Pads::push(double travel_mm, const StressCurve& curve) const {
    double force = 0, along_u = 0, along_v = 0;
    for_each_piece(
        travel_mm, curve,
        [&](const Group& group, const Sums& sums, const StressCurve::Corner& corner, double slope) {
            // kPa at gap 0, and how it falls with the gap
            const double per_mm = slope / group.thickness_mm;
            const double at_0 = corner.kpa + per_mm * travel_mm - slope * corner.strain;
            force += sums.area * at_0 - per_mm * sums.area_gap;
            along_u += sums.area_u * at_0 - per_mm * sums.area_gap_u;
            along_v += sums.area_v * at_0 - per_mm * sums.area_gap_v;
        });
    if (!(force > 0)) return {};
    return {force * 1e-3, along_u / force, along_v / force};
}

Pads::Taken Pads::taken(double travel_mm, const StressCurve& curve, double thin_mm) const {
    double all = 0, thin = 0;  // kPa mm3
    for_each_piece(
        travel_mm, curve,
        [&](const Group& group, const Sums& sums, const StressCurve::Corner& corner, double slope) {
            // strain beyond the corner: reached - gap / thickness
            const double t = group.thickness_mm, reached = travel_mm / t - corner.strain;
            const double strains = sums.area * reached - sums.area_gap / t;
            const double squares =
                sums.area * reached * reached - 2 * reached * sums.area_gap / t + sums.area_gap2 / (t * t);
            const double energy =
                t * (corner.energy * sums.area + corner.kpa * strains + slope / 2 * squares);
            all += energy;
            if (t < thin_mm) thin += energy;
        });
    return {all * 1e-6, thin * 1e-6};
}

double Pads::travel_to_strain(double strain) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Group& group : groups_)
        least = std::min(least, group.least_gap_mm + strain * group.thickness_mm);
    return least;
}

Pads::Most Pads::most_squeezed(double travel_mm) const {
    Most most;
    for (const Group& group : groups_) {
        const double strain = (travel_mm - group.least_gap_mm) / group.thickness_mm;
        if (strain > most.strain) most = {strain, group.u_mm, group.v_mm};
    }
    return most;
}

double Pads::area_mm2(double travel_mm) const {
    double area = 0;
    for (const Group& group : groups_) area += below(group, travel_mm).area;
    return area;
}

double Pads::least_gap_mm() const {
    return travel_to_strain(0);
}

}  // namespace snug
