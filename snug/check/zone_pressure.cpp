#include "snug/check/zone_pressure.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace snug {
namespace {

constexpr double kSide = 10;  // mm

}  // namespace

double most_mean_kpa(std::span<const PadColumn> columns, double travel_mm, const StressCurve& curve) {
    using Square = std::pair<std::int64_t, std::int64_t>;
    std::map<Square, double> newton;  // by halves of a side
    for (const PadColumn& column : columns) {
        const double strain = (travel_mm - column.gap_mm) / column.thickness_mm;
        if (!(strain > 0)) continue;
        const double push = curve.at(strain).kpa * 1e-3 * column.area_mm2;
        const auto u = static_cast<std::int64_t>(std::floor(column.u_mm * 2 / kSide));
        const auto v = static_cast<std::int64_t>(std::floor(column.v_mm * 2 / kSide));
        for (std::int64_t i = u - 1; i <= u; ++i)
            for (std::int64_t k = v - 1; k <= v; ++k) newton[{i, k}] += push;
    }
    double most = 0;
    for (const auto& [square, push] : newton) most = std::max(most, push * 1e3 / (kSide * kSide));
    return most;
}

}  // namespace snug
